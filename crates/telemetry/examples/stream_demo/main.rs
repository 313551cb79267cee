//! A host without keys, for viewers: `cargo run -p telemetry --example stream_demo [address]`.
//! The default address is 127.0.0.1:8765.

#![expect(clippy::print_stdout, reason = "says where it listens")]
#![cfg_attr(test, allow(dead_code, reason = "it has no tests that ask"))]

mod synthetic;

use std::time::{Duration, SystemTime};
use std::{error::Error, sync::Arc};

use synthetic::{KEY, Synthetic, TICK_HZ};
use telemetry::Topic;
use telemetry::stream::{Publisher, ServerSettings, StreamServer, serve};

const FRAMES_HZ: u32 = 30;

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut settings = ServerSettings::default();
    if let Some(address) = std::env::args().nth(1) {
        settings.address = address.parse()?;
    }
    let server = StreamServer::listen(settings)?;
    println!("A synthetic host listens at {}; Ctrl-C ends it.", server.url());
    let publisher = server.publisher();
    publisher.publish(now(), &synthetic::catalogue());
    publisher.publish(now(), &synthetic::voice(KEY.into(), 1));
    let host = Arc::new(Synthetic::default());
    host.tell_by(publisher.clone());
    let backend = Arc::clone(&host);
    tokio::select! {
        served = serve(server, backend) => served?,
        () = swing(&publisher, &host) => {}
        interrupted = tokio::signal::ctrl_c() => interrupted?,
    }
    println!("{} requests were answered.", host.asked().len());
    Ok(())
}

#[expect(clippy::infinite_loop, reason = "whoever waits for it ends it")]
async fn swing(publisher: &Publisher, host: &Synthetic) {
    let mut frames = tokio::time::interval(Duration::from_secs(1) / FRAMES_HZ);
    let ticks = TICK_HZ / FRAMES_HZ;
    let mut tick = 0;
    loop {
        frames.tick().await;
        if publisher.is_followed(Topic::Block(KEY)) && host.value("m").is_some() {
            publisher.publish(now(), &synthetic::block(tick, ticks));
        }
        publisher.publish(now(), &synthetic::overview(tick, ticks));
        tick += u64::from(ticks);
    }
}

fn now() -> u64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.ok().and_then(|since| u64::try_from(since.as_nanos()).ok()).unwrap_or(0)
}
