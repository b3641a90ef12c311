//! Checks the host named in a request.
//!
//! Without this check, a page of another site could point its own name at 127.0.0.1 after it has loaded (DNS rebinding)
//! and read this server's files as if they belonged to that site. An address cannot be rebound.

use std::net::{IpAddr, Ipv6Addr};

use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// The accepted host names.
#[derive(Clone, Debug)]
pub enum Hosts {
    /// All names: other machines can connect, and the server cannot know which names they use.
    Any,
    /// `localhost`, IP addresses, and these names.
    Named(Vec<String>),
}

impl Hosts {
    /// Returns whether a `Host` header names this server. The port is ignored, because a tunnel may use another.
    fn contains(&self, host: &str) -> bool {
        let Hosts::Named(allowed) = self else { return true };
        let name = match host.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            Some((address, _)) => return address.parse::<Ipv6Addr>().is_ok(),
            None => host.split(':').next().unwrap_or_default(),
        };
        name.eq_ignore_ascii_case("localhost")
            || name.parse::<IpAddr>().is_ok()
            || allowed.iter().any(|host| host.eq_ignore_ascii_case(name))
    }
}

/// Refuses requests with a different `Host`, with none, or with several.
pub async fn check(hosts: Hosts, request: Request, next: Next) -> Response {
    let mut headers = request.headers().get_all(header::HOST).iter();
    let (Some(host), None) = (headers.next(), headers.next()) else {
        return (StatusCode::BAD_REQUEST, "A request needs exactly one Host header.\n").into_response();
    };
    let host = host.to_str().unwrap_or_default();
    // Clients send the host in the request target to proxies, as in `GET http://host/path`.
    if request.uri().authority().is_some_and(|authority| authority != host) {
        return (StatusCode::BAD_REQUEST, "The request target and the Host header name different hosts.\n")
            .into_response();
    }
    if !hosts.contains(host) {
        let remedy = "This server does not answer to this name. Allow it with --allow-host.\n";
        return (StatusCode::MISDIRECTED_REQUEST, remedy).into_response();
    }
    next.run(request).await
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_addresses_and_allowed_names_are_answered() {
        let named = Hosts::Named(vec!["play.example".to_string()]);
        for host in
            ["localhost", "LocalHost:8080", "127.0.0.1", "10.0.0.1:1", "[::1]", "[fe80::2]:8080", "play.example:443"]
        {
            assert!(named.contains(host), "{host}");
        }
        let others = ["", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "[::1", "::1"];
        for host in others {
            assert!(!named.contains(host) && Hosts::Any.contains(host), "{host}");
        }
    }
}
