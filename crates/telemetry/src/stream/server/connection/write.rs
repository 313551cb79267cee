//! What is sent to a client, and in which order.

use futures_util::SinkExt as _;
use futures_util::stream::SplitSink;
use tokio::sync::mpsc;
use tokio::time::{Duration, Interval, MissedTickBehavior, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::protocol::CloseFrame;
use tokio_tungstenite::tungstenite::protocol::frame::coding::CloseCode;
use tokio_tungstenite::tungstenite::{Bytes, Message, Utf8Bytes};

use super::ConnectionEnd;
use crate::stream::byte_stream::BoxedStream;
use crate::stream::protocol::Level;
use crate::stream::server::ServerLimits;
use crate::stream::server::outbox::Outbox;

/// The sending end of a connection.
type FrameSink = SplitSink<WebSocketStream<BoxedStream>, Message>;

/// Pings in the time after which a client counts as gone.
const PINGS: u32 = 3;

/// Shortest time between two sentences on what was dropped.
const BETWEEN_WARNINGS: Duration = Duration::from_secs(1);

/// Sends what waits, control first, until the client takes no more or all is sent.
pub(super) async fn run(
    sink: &mut FrameSink,
    mut control: mpsc::Receiver<Message>,
    outbox: &Outbox,
    limits: &ServerLimits,
) -> ConnectionEnd {
    let mut pings = interval(limits.idle / PINGS);
    let mut warnings = interval(BETWEEN_WARNINGS);
    loop {
        let next = tokio::select! {
            biased;
            Some(message) = control.recv() => {
                outbox.taken(&message);
                message
            }
            _now = pings.tick() => Message::Ping(Bytes::new()),
            _now = warnings.tick() => {
                warn(outbox);
                continue;
            }
            message = outbox.sample() => message,
            () = outbox.finished() => return ConnectionEnd::Over,
        };
        // A client that takes nothing for so long is gone, or will not catch up.
        match timeout(limits.stall, sink.send(next)).await {
            Ok(Ok(())) => {}
            Ok(Err(_gone)) => return ConnectionEnd::Left,
            Err(_elapsed) => return ConnectionEnd::Stalled,
        }
    }
}

/// Sends the close frame with the reason, if the client may still hear it.
///
/// `closing` is why the server closes, if it does.
pub(super) async fn close(sink: &mut FrameSink, end: ConnectionEnd, closing: &str) {
    /// Longest time for sending it.
    const GRACE: Duration = Duration::from_secs(1);
    /// Longest reason that a close frame carries (bytes).
    const LONGEST: usize = 123;
    let (code, reason) = match end {
        ConnectionEnd::Left => return,
        ConnectionEnd::Stalled => (CloseCode::Policy, "you do not take what is sent to you"),
        ConnectionEnd::Silent => (CloseCode::Policy, "nothing was heard of you, not even a pong"),
        ConnectionEnd::TooLarge => (CloseCode::Size, "your message is larger than this host takes"),
        ConnectionEnd::Over => (CloseCode::Away, &closing[..closing.floor_char_boundary(LONGEST)]),
    };
    let frame = CloseFrame { code, reason: Utf8Bytes::from(reason) };
    let _heard = timeout(GRACE, sink.send(Message::Close(Some(frame)))).await;
}

/// Creates an interval whose ticks are never closer than `period`, however long a message took.
fn interval(period: Duration) -> Interval {
    let mut interval = tokio::time::interval(period);
    interval.set_missed_tick_behavior(MissedTickBehavior::Delay);
    interval
}

/// Sends how many samples were dropped, if any were.
fn warn(outbox: &Outbox) {
    let dropped = outbox.take_dropped();
    if dropped > 0 {
        let text = format!("{dropped} messages were dropped: they come faster than they are taken");
        outbox.status(Level::Warning, text, None);
    }
}
