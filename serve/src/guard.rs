//! Who may ask. Each check stands for an attack: `Host` for names that lead here, `Origin` for forms and scripts of other
//! pages, the token for other users of the machine, size and time for what would fill or hold it.

use std::time::Duration;

use http_body_util::{BodyExt, Full, LengthLimitError, Limited};
use hyper::body::{Body, Bytes, Incoming};
use hyper::header::{CONNECTION, CONTENT_TYPE, HOST, HeaderMap, HeaderName, HeaderValue, ORIGIN};
use hyper::http::request::Parts;
use hyper::{Method, Response, StatusCode};

pub type Reply = Response<Full<Bytes>>;

/// Largest body: a scene has at most half of it, and quotes and line ends take two bytes in JSON.
const LARGEST: usize = 2 << 20;
/// How long a request may take to arrive.
pub const PATIENCE: Duration = Duration::from_secs(10);

const TOKEN: HeaderName = HeaderName::from_static("x-token");

/// What every reply says to the browser: nothing from elsewhere, nothing inline, no frame, no guesses.
const PROTECTION: [(&str, &str); 5] = [
    (
        "content-security-policy",
        "default-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
];

pub struct Guard {
    token: String,
    hosts: [String; 2],
}

/// Why a request is not answered, in words.
pub struct Refusal {
    status: StatusCode,
    words: String,
    /// Whether the connection ends: what is still to come is not read.
    last: bool,
}

impl Refusal {
    pub fn new(status: StatusCode, words: impl Into<String>) -> Refusal {
        let words = words.into();
        Refusal {
            status,
            words,
            last: false,
        }
    }

    fn last(status: StatusCode, words: &str) -> Refusal {
        let mut refusal = Refusal::new(status, words);
        refusal.last = true;
        refusal
    }

    pub fn reply(self) -> Reply {
        let mut reply = reply("text/plain; charset=utf-8", self.words);
        *reply.status_mut() = self.status;
        if self.last {
            reply
                .headers_mut()
                .insert(CONNECTION, HeaderValue::from_static("close"));
        }
        reply
    }
}

/// What was asked for.
pub fn reply(kind: &'static str, body: impl Into<Bytes>) -> Reply {
    let mut reply = Response::new(Full::new(body.into()));
    reply.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    reply
}

/// What every reply has besides its own.
pub fn protect(headers: &mut HeaderMap) {
    for (name, value) in PROTECTION {
        headers.insert(HeaderName::from_static(name), HeaderValue::from_static(value));
    }
}

impl Guard {
    pub fn new(port: u16, token: String) -> Guard {
        let hosts = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"));
        Guard { token, hosts }
    }

    pub fn address(&self) -> String {
        format!("http://{}/?token={}", self.hosts[0], self.token)
    }

    /// Whether a request may be answered; `free` is what anyone may read.
    pub fn check(&self, head: &Parts, free: bool) -> Result<(), Refusal> {
        let forbidden = |words| Refusal::last(StatusCode::FORBIDDEN, words);
        let one = |name: HeaderName| {
            let mut all = head.headers.get_all(name).into_iter();
            let first = all.next().and_then(|value| value.to_str().ok());
            first.filter(|_| all.next().is_none())
        };
        let own = |host: &str| self.hosts.iter().any(|known| known == host);
        if !one(HOST).is_some_and(own) || head.uri.host().is_some() {
            return Err(forbidden("this host is not served here"));
        }
        let token = if head.method == Method::POST {
            let own = |origin: &str| origin.strip_prefix("http://").is_some_and(own);
            if !one(ORIGIN).is_some_and(own) {
                return Err(forbidden("only the page itself may ask"));
            }
            one(TOKEN)
        } else {
            head.uri.query().and_then(|query| query.strip_prefix("token="))
        };
        match free || token == Some(&self.token) {
            true => Ok(()),
            false => Err(forbidden(
                "open the whole address that lemnis serve has printed, with its token",
            )),
        }
    }
}

/// A body, if it is not too large and does not take too long.
pub async fn body(body: Incoming) -> Result<Bytes, Refusal> {
    let large = || Refusal::last(StatusCode::PAYLOAD_TOO_LARGE, "more than a scene may have");
    if body.size_hint().lower() > LARGEST as u64 {
        return Err(large());
    }
    match tokio::time::timeout(PATIENCE, Limited::new(body, LARGEST).collect()).await {
        Ok(Ok(whole)) => Ok(whole.to_bytes()),
        Ok(Err(error)) if error.is::<LengthLimitError>() => Err(large()),
        Ok(Err(_)) => Err(Refusal::last(StatusCode::BAD_REQUEST, "the request broke off")),
        Err(_) => Err(Refusal::last(
            StatusCode::REQUEST_TIMEOUT,
            "the request took too long to arrive",
        )),
    }
}
