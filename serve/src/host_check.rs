//! Which names of this server requests may use.
//!
//! A page of another site can give its own name the address 127.0.0.1 once it is loaded (DNS rebinding), and its
//! browser then takes this server for a part of that site. All files here are public; still nobody but this machine is
//! meant to read them while only this machine can connect.

use std::net::{IpAddr, Ipv6Addr};

use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// The names that are answered.
#[derive(Clone, Debug)]
pub enum Hosts {
    /// Other machines connect, by names that only they know.
    Any,
    /// Those of this machine, and these.
    Local(Vec<String>),
}

impl Hosts {
    /// Whether a `Host` header names this server. The port does not matter: a tunnel may have another.
    fn holds(&self, host: &str) -> bool {
        let Hosts::Local(named) = self else { return true };
        let name = match host.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            Some((address, _)) => return address.parse::<Ipv6Addr>().is_ok_and(|address| address.is_loopback()),
            None => host.split(':').next().unwrap_or_default(),
        };
        name.eq_ignore_ascii_case("localhost")
            || name.parse::<IpAddr>().is_ok_and(|address| address.is_loopback())
            || named.iter().any(|one| one.eq_ignore_ascii_case(name))
    }
}

/// Answers a request that uses another name with the remedy.
pub async fn check(hosts: Hosts, request: Request, next: Next) -> Response {
    let host = request.headers().get(header::HOST).and_then(|host| host.to_str().ok());
    if host.is_some_and(|host| hosts.holds(host)) {
        return next.run(request).await;
    }
    let sentence = "This server answers to the names of its own machine only. Name another with --allow-host.\n";
    (StatusCode::MISDIRECTED_REQUEST, sentence).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_this_machine_are_answered_and_no_others_unless_they_are_named() {
        let local = Hosts::Local(vec!["play.example".to_string()]);
        for host in
            ["localhost", "LocalHost:8080", "127.0.0.1", "127.9.9.9:1", "[::1]", "[::1]:8080", "play.example:443"]
        {
            assert!(local.holds(host), "{host}");
        }
        let others = [
            "",
            "evil.example",
            "localhost.evil.example",
            "127.0.0.1.evil.example",
            "10.0.0.1",
            "[::2]",
            "[::1",
            "::1",
        ];
        for host in others {
            assert!(!local.holds(host) && Hosts::Any.holds(host), "{host}");
        }
    }
}
