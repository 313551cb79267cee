//! Messages to a client, and their order.

use futures_util::{SinkExt as _, stream::SplitSink};
use tokio::sync::mpsc;
use tokio::time::{Duration, Interval, MissedTickBehavior, timeout};
use tokio_tungstenite::WebSocketStream;
use tokio_tungstenite::tungstenite::protocol::{CloseFrame, frame::coding::CloseCode};
use tokio_tungstenite::tungstenite::{Bytes, Message, Utf8Bytes};

use super::ConnectionEnd;
use crate::stream::server::{ServerLimits, outbox::Outbox};
use crate::stream::{byte_stream::BoxedStream, protocol::Level};

type FrameSink = SplitSink<WebSocketStream<BoxedStream>, Message>;

/// Pings in the time after which a silent client is cut.
const PINGS: u32 = 3;

/// Shortest time between two warnings about dropped samples.
const BETWEEN_WARNINGS: Duration = Duration::from_secs(1);

/// Sends waiting messages, control first, until the client accepts no more or all are sent.
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
        // A client that does not read for so long is gone, or will not catch up.
        match timeout(limits.stall, sink.send(next)).await {
            Ok(Ok(())) => {}
            Ok(Err(_gone)) => return ConnectionEnd::Left,
            Err(_elapsed) => return ConnectionEnd::Stalled,
        }
    }
}

/// Sends the close frame with the reason, if the client may still read it; `closing` is the
/// server's reason for closing, if it closes.
pub(super) async fn close(sink: &mut FrameSink, end: ConnectionEnd, closing: &str) {
    const GRACE: Duration = Duration::from_secs(1);
    /// Longest reason in a close frame (bytes).
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

fn warn(outbox: &Outbox) {
    let dropped = outbox.take_dropped();
    if dropped > 0 {
        let text = format!("{dropped} messages were dropped: they come faster than they are taken");
        outbox.status(Level::Warning, text, None);
    }
}
