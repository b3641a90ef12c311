//! `If-Range`: sends the rest of an interrupted download, or the whole file if it has changed in the meantime.

use axum::body::Body;
use axum::extract::Request;
use axum::http::{StatusCode, header};
use axum::middleware::Next;
use axum::response::Response;

/// Evaluates `If-Range`, which `ServeDir` ignores.
///
/// `If-Match` makes the same comparison, and `ServeDir` answers 412 if it fails. A date never matches, so a request
/// with a date receives the whole file.
pub async fn evaluate(request: Request, next: Next) -> Response {
    let (mut whole, body) = request.into_parts();
    let (Some(validator), true) = (whole.headers.remove(header::IF_RANGE), whole.headers.contains_key(header::RANGE))
    else {
        return next.run(Request::from_parts(whole, body)).await;
    };
    let mut part = whole.clone();
    part.headers.insert(header::IF_MATCH, validator);
    whole.headers.remove(header::RANGE);
    let response = next.clone().run(Request::from_parts(part, Body::empty())).await;
    match response.status() {
        StatusCode::PRECONDITION_FAILED => next.run(Request::from_parts(whole, body)).await,
        _ => response,
    }
}
