//! Measures the time from a slider to the key: a client of the stream sets the stiffness of a key
//! that a finger holds down, and waits for the first tick with another force.
//!
//! `cargo run --release -p host --example slider_to_force`
#![expect(clippy::expect_used, clippy::print_stdout, reason = "a measurement")]

use std::collections::BTreeSet;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use hdrhistogram::Histogram;
use host::control::{Folders, RequestHandler, StreamSink};
use host::session::{RunOptions, RunSession};
use scene::Scene;
use telemetry::request::Change;
use telemetry::stream::{Client, Dial, ServerSettings, StreamServer, serve};
use telemetry::{Arrival, KeyBlock, Request, Source as _, Topic, Update};

const KEY: u8 = 39;
const MOVES: u32 = 200;
/// Force of the finger (N).
const WEIGHT: f64 = 3.0;
const PATIENCE: Duration = Duration::from_secs(30);

fn main() {
    let silent = [("pianist.performance".to_owned(), "none".to_owned())];
    let scene =
        Scene::load(&scene::Library::default(), "springs", &silent).expect("a scene of ours");
    let session = RunSession::prepare(&scene, RunOptions::default(), &|_| {}).expect("a session");
    let requests = Arc::new(RequestHandler::new(scene, session.handle(), Folders::default()));
    let mut runtime = tokio::runtime::Builder::new_multi_thread();
    let runtime = runtime.worker_threads(1).enable_all().build().expect("a runtime");
    let address = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
    let server = {
        let _inside = runtime.enter();
        StreamServer::listen(ServerSettings { address, ..ServerSettings::default() })
            .expect("a port")
    };
    let dial = Dial { address: server.url(), ..Dial::default() };
    session.observe(Box::new(StreamSink::new(server.publisher())));
    runtime.spawn(serve(server, requests));
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let host = scope.spawn(|| session.run(&stop));
        let times = measure(&mut Client::connect(dial, None));
        stop.store(true, Ordering::Release);
        let report = host.join().expect("no panic").expect("a report");
        let at = |quantile| times.value_at_quantile(quantile) as f64 / 1e3;
        println!(
            "slider to force, {MOVES} moves at {} Hz: p50 {:.2} ms, p99 {:.2} ms, longest {:.2} ms; \
             {} of {} ticks late",
            report.extent.tick_hz,
            at(0.5),
            at(0.99),
            times.max() as f64 / 1e3,
            report.deadline.missed,
            report.extent.ticks,
        );
    });
}

/// Moves the slider to and fro; returns the times (us).
fn measure(client: &mut Client) -> Histogram<u64> {
    client.follow(&BTreeSet::from([Topic::Catalogue, Topic::Voices, Topic::Block(KEY)]));
    let (began, period) = wait(client, |update| {
        let Update::Catalogue(it) = update else { return None };
        Some((it.began, 1_000_000_000 / u64::from(it.tick_hz)))
    });
    client.ask(Request::Press { key: KEY, newtons: WEIGHT });
    wait(client, |update| {
        let Update::Block(block) = update else { return None };
        block.position.last().filter(|it| 8e-3 < **it).map(|_| ())
    });
    let mut held = 0.0;
    let mut times = Histogram::new(3).expect("a histogram");
    for n in 0..MOVES {
        // Out of step with the ticks, like a hand.
        std::thread::sleep(Duration::from_micros(40_000 + u64::from(n) * 37 % 1_000));
        let asked = SystemTime::now().duration_since(UNIX_EPOCH).expect("a clock").as_nanos();
        let value = 20_000.0 + f64::from(n % 2) * 4_000.0;
        let change = Change { key: KEY, parameter: "k1".into(), value };
        client.ask(Request::Set { changes: vec![change] });
        let tick = first_other_force(client, &mut held);
        let felt = u128::from(began + tick * period);
        times.saturating_record(u64::try_from(felt.saturating_sub(asked) / 1_000).unwrap_or(0));
    }
    times
}

/// Returns the first tick of the next voice with a force other than `held`.
fn first_other_force(client: &mut Client, held: &mut f64) -> u64 {
    let mut voice = u32::MAX;
    wait(client, |update| {
        if let Update::Voice(it) = &update
            && it.key == u32::from(KEY)
        {
            voice = it.revision;
        }
        let Update::Block(block) = update else { return None };
        changed(&block, voice, held)
    })
}

/// Returns the first tick of this or a later voice with a changed force; updates `held`.
fn changed(block: &KeyBlock, voice: u32, held: &mut f64) -> Option<u64> {
    for ((force, after), revision) in block.sent.iter().zip(&block.after).zip(&block.revision) {
        let is_other = force.to_bits() != held.to_bits();
        *held = *force;
        if voice <= *revision && is_other {
            return Some(block.tick + u64::from(*after));
        }
    }
    None
}

fn wait<T>(client: &mut Client, mut wanted: impl FnMut(Update) -> Option<T>) -> T {
    let end = Instant::now() + PATIENCE;
    loop {
        assert!(Instant::now() < end, "nothing came");
        match client.next() {
            Some(Arrival::Update { update, .. }) => {
                if let Some(found) = wanted(*update) {
                    return found;
                }
            }
            Some(Arrival::Reply { result, .. }) => {
                result.expect("a host that does as it is asked");
            }
            Some(Arrival::Anew) => {}
            None => std::thread::sleep(Duration::from_micros(200)),
        }
    }
}
