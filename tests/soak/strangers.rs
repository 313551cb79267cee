//! Disturbances of a run in real time: clients that stall or send rubbish, busy processors, and a
//! shell that stops the process for a short time.

use std::io::{self, Read as _, Write as _};
use std::net::{Ipv4Addr, SocketAddr, TcpStream};
use std::num::NonZeroUsize;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

use boards::links::random::Random;
use host::control::{RequestHandler, StreamSink};
use host::session::RunSession;
use telemetry::stream::{Closer, ServerSettings, StreamServer, serve};

/// Length of a stop (s), and of the pauses before and between.
const STOPPED: f64 = 0.3;
const PAUSE: Duration = Duration::from_secs(7);

#[derive(Debug)]
pub(crate) struct Strangers {
    threads: Vec<JoinHandle<()>>,
    closer: Closer,
    shared: Arc<StrangerState>,
}

#[derive(Debug, Default)]
struct StrangerState {
    is_over: AtomicBool,
    clients: AtomicU64,
    stops: AtomicU64,
}

impl StrangerState {
    fn goes_on(&self, pause: Duration) -> bool {
        let mut left = pause;
        while !self.is_over.load(Ordering::Acquire) {
            let Some(rest) = left.checked_sub(LOOK) else { return true };
            left = rest;
            boards::links::pause(LOOK);
        }
        false
    }
}

const LOOK: Duration = Duration::from_millis(20);

impl Strangers {
    pub(crate) fn start(session: &RunSession, requests: Arc<RequestHandler>) -> io::Result<Self> {
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, 0));
        let settings = ServerSettings { address, insecure: true, ..ServerSettings::default() };
        let server = StreamServer::listen(settings)?;
        let (address, closer) = (server.address(), server.closer());
        session.observe(Box::new(StreamSink::new(server.publisher())));
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        let shared = Arc::new(StrangerState::default());
        let served = move || {
            // It ends when it is closed; an error ends it too, without any client.
            let _ended = runtime.block_on(serve(server, requests));
        };
        let mut threads = vec![std::thread::spawn(served)];
        let mut start = |work: fn(&StrangerState, SocketAddr)| {
            let shared = Arc::clone(&shared);
            threads.push(std::thread::spawn(move || work(&shared, address)));
        };
        start(stall);
        start(send_rubbish);
        start(stop_the_process);
        (0..processors()).for_each(|_| start(keep_busy));
        Ok(Self { threads, closer, shared })
    }

    pub(crate) fn stop(self) -> Vec<String> {
        self.shared.is_over.store(true, Ordering::Release);
        self.closer.close("the trial is over".to_owned());
        for thread in self.threads {
            // A panic of a stranger is not the host's fault.
            let _ended = thread.join();
        }
        let count = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
        vec![
            format!("{} clients stalled or sent rubbish", count(&self.shared.clients)),
            format!("the process was stopped {} times for {STOPPED} s", count(&self.shared.stops)),
            format!("{} threads took turns in keeping the processors busy", processors()),
        ]
    }
}

const HANDSHAKE: &str = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\n\
                         Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\
                         Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\
                         Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n";

fn connect(shared: &StrangerState, address: SocketAddr) -> io::Result<TcpStream> {
    let stream = TcpStream::connect(address)?;
    stream.set_write_timeout(Some(Duration::from_secs(1)))?;
    stream.set_read_timeout(Some(Duration::from_secs(1)))?;
    shared.clients.fetch_add(1, Ordering::Relaxed);
    Ok(stream)
}

fn frame(text: &str) -> Vec<u8> {
    let length = u16::try_from(text.len()).unwrap_or(u16::MAX).to_be_bytes();
    [&[0x81, 0x80 | 0x7e], &length[..], &[0; 4], text.as_bytes()].concat()
}

fn stall(shared: &StrangerState, address: SocketAddr) {
    let subscriptions: Vec<_> =
        (1..200).map(|id| format!(r#"{{"id":{id},"channelId":{id}}}"#)).collect();
    let wish = format!(r#"{{"op":"subscribe","subscriptions":[{}]}}"#, subscriptions.join(","));
    loop {
        let stalled = connect(shared, address).and_then(|mut stream| {
            stream.write_all(HANDSHAKE.as_bytes())?;
            // The answer to the handshake; the rest stays unread.
            let _answer = stream.read(&mut [0; 64])?;
            stream.write_all(&frame(&wish))?;
            Ok(stream)
        });
        // The host drops it at some time, and it returns.
        if !shared.goes_on(PAUSE) {
            return;
        }
        drop(stalled);
    }
}

fn send_rubbish(shared: &StrangerState, address: SocketAddr) {
    let mut random = Random(1);
    while shared.goes_on(Duration::from_millis(50)) {
        let rubbish: Vec<u8> = (0..4096).map(|_| random.next().to_le_bytes()[0]).collect();
        let polite = random.happens(0.5);
        let _turned_away = connect(shared, address).and_then(|mut stream| {
            if polite {
                stream.write_all(HANDSHAKE.as_bytes())?;
            }
            stream.write_all(&rubbish)
        });
    }
}

fn keep_busy(shared: &StrangerState, _address: SocketAddr) {
    while shared.goes_on(Duration::from_secs(3)) {
        let mut random = Random(1);
        // Some hundred million numbers are about a second.
        for _ in 0..300 {
            let sum = (0..1_000_000).fold(0_u64, |sum, _| sum.wrapping_add(random.next()));
            std::hint::black_box(sum);
            if shared.is_over.load(Ordering::Acquire) {
                return;
            }
        }
    }
}

fn stop_the_process(shared: &StrangerState, _address: SocketAddr) {
    let process = std::process::id();
    let script = format!("kill -STOP {process}; sleep {STOPPED}; kill -CONT {process}");
    while shared.goes_on(PAUSE) {
        let mut shell = Command::new("/bin/sh");
        let stopped = shell.args(["-c", &script]).stdin(Stdio::null()).status();
        shared.stops.fetch_add(u64::from(stopped.is_ok_and(|it| it.success())), Ordering::Relaxed);
    }
}

fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, NonZeroUsize::get)
}
