use std::sync::Arc;
use std::time::Duration;

use documents::shown;
use telemetry::stream::{Closer, Publisher, StreamServer};
use tokio::task::JoinHandle;

use super::{Failure, streaming, system, tell};
use host::control::{
    Answers, Clients, ControlServer, ProgramListener, RepeatedLook, RequestHandler, StartingHost,
    StatusPublisher, StreamAddress, StreamSink, follow_load, serve, socket_path,
    watch_descriptions,
};
use host::session::RunSession;
use scene::{LinksConfig, Scene};

#[derive(Debug, Default)]
pub(super) struct Endpoints {
    clients: Clients,
    stream: Option<ServedStream>,
    requests: Option<Arc<RequestHandler>>,
}

#[derive(Debug)]
struct ServedStream {
    publisher: Publisher,
    closer: Closer,
    news: String,
    serving: JoinHandle<std::io::Result<()>>,
    status: StatusPublisher,
}

impl Endpoints {
    /// Answers requests to a host that will run `scene`, before any rehearsal; `clients` are those
    /// of the control socket, which `starting` has answered so far.
    ///
    /// # Errors
    /// If the requested stream cannot be opened.
    pub(super) fn open(
        scene: &Scene,
        starting: &StartingHost,
        clients: Clients,
        wanted: Option<&streaming::WantedStream>,
    ) -> Result<Self, Failure> {
        let folders = wanted.map(|it| it.folders.clone()).unwrap_or_default();
        let stream = wanted.map(ListeningStream::open).transpose()?.flatten();
        // A client that asks for the stream's address waits until it exists.
        let address = stream.as_ref().map(|it| it.address.clone());
        let requests = starting.begin(scene.clone(), folders, address);
        let stream = stream.map(|it| it.serve(&requests)).transpose().map_err(system)?;
        Ok(Self { clients, stream, requests: Some(requests) })
    }

    /// Watches the descriptions of the voices, until the result is dropped.
    pub(super) fn watch(&self) -> Result<Option<RepeatedLook>, Failure> {
        let requests = self.requests.as_ref().map(Arc::clone);
        requests.map(watch_descriptions).transpose().map_err(system)
    }

    /// Lowers the fidelity of resting keys while ticks are overloaded, until the result is dropped.
    pub(super) fn watch_load(&self) -> Result<Option<RepeatedLook>, Failure> {
        let requests = self.requests.as_ref().map(Arc::clone);
        requests.map(follow_load).transpose().map_err(system)
    }

    /// Listens for program changes, until the result is dropped; logs a failure. Also lists the
    /// user's own instruments, which clients and programs may name.
    pub(super) fn hear_programs(&self) -> Option<ProgramListener> {
        self.list_own_instruments();
        let started = ProgramListener::start(self.requests.as_ref()?);
        started.unwrap_or_else(|why| {
            tell(&format!("program changes are not heard: {why}"));
            None
        })
    }

    /// Lists the user's own instruments in the catalogue; their models may take a second to load.
    fn list_own_instruments(&self) {
        if let Some(requests) = self.requests() {
            std::thread::spawn(move || requests.list_own_instruments());
        }
    }

    pub(super) fn publisher(&self) -> Option<Publisher> {
        self.stream.as_ref().map(|stream| stream.publisher.clone())
    }

    pub(super) fn requests(&self) -> Option<Arc<RequestHandler>> {
        self.requests.as_ref().map(Arc::clone)
    }

    pub(super) fn observe(&self, session: &RunSession) {
        if let Some(stream) = &self.stream {
            session.observe(Box::new(StreamSink::new(stream.publisher.clone())));
        }
    }

    /// Returns the messages at the start of the run.
    pub(super) fn news(&self, scene: &Scene, session: &RunSession) -> Vec<String> {
        let (name, hz, n_voices) = (&scene.name, session.plan().tick_hz, session.plan().n_voices);
        let keys = match &scene.links {
            LinksConfig::Simulated => "simulated keys".to_owned(),
            LinksConfig::Boards(boards) => format!("boards on {} links", boards.buses.len()),
        };
        let midi = session.midi();
        let is_silent = midi == "none" && scene.links == LinksConfig::Simulated;
        let remedy = if is_silent { ", so nothing is heard: give --sound or --midi" } else { "" };
        let plays =
            format!("plays {name:?}: {n_voices} voices at {hz} Hz on {keys}; MIDI: {midi}{remedy}");
        let streams = self.stream.as_ref().map(|stream| stream.news.clone());
        [Some(plays), streams].into_iter().flatten().collect()
    }

    /// Waits until all clients have their answer, and closes the stream with the reason `why`.
    pub(super) async fn leave(self, why: &str) {
        /// Upper bound of the time to close a stream.
        const GRACE: Duration = Duration::from_secs(4);
        let stream = async {
            if let Some(stream) = self.stream {
                let _published = tokio::time::timeout(GRACE, stream.status.finish()).await;
                stream.closer.close(why.to_owned());
                let _closed = tokio::time::timeout(GRACE, stream.serving).await;
            }
        };
        tokio::join!(self.clients.leave(), stream);
    }
}

/// Reachability of this process for commands.
#[derive(Debug, Default)]
pub(super) struct Reach {
    /// Reason why `dash` and other commands cannot reach it, in a sentence.
    notice: Option<String>,
    /// Reason why not even `letoff stop` can, in a sentence.
    unstoppable: Option<String>,
}

impl Reach {
    /// Prints the notice, and refuses to drive boards that nothing could stop.
    pub(super) fn check(&self) -> Result<(), Failure> {
        self.notice.iter().for_each(|notice| tell(notice));
        self.unstoppable.clone().map_or(Ok(()), |why| Err(Failure::Running(why)))
    }

    /// Like [`Self::check`], but allows simulated keys without a stop.
    pub(super) fn check_for(&self, links: &LinksConfig) -> Result<(), Failure> {
        let checked = self.check();
        if *links == LinksConfig::Simulated { Ok(()) } else { checked }
    }
}

/// Serves this user's control socket with `answers`, and stops by the name of this process.
pub(super) fn listen<A: Answers>(answers: &Arc<A>) -> (Clients, Reach) {
    let clients = Clients::default();
    let path = socket_path();
    // A second host, or a machine without a folder for sockets, runs nevertheless.
    let answer = |server| {
        // The task ends with the runtime, and removes the socket.
        tokio::spawn(serve(server, Arc::clone(answers), clients.clone()));
    };
    let by_path = ControlServer::listen(&path).map(answer).err();
    let by_name = ControlServer::listen_by_name().map(answer).err();
    let notice = by_path.as_ref().map(|error| {
        format!(
            "`letoff set`, `dash` and `instruments use` do not reach this process: {}: {error}; \
             give it a place of its own with LETOFF_SOCKET",
            shown(&path)
        )
    });
    let unstoppable = by_path.zip(by_name).map(|(path, name)| {
        format!("boards are driven only by a host that `letoff stop` reaches: {path}, {name}")
    });
    (clients, Reach { notice, unstoppable })
}

struct ListeningStream {
    server: StreamServer,
    address: StreamAddress,
    news: String,
}

impl ListeningStream {
    /// Listens, if the port is free.
    fn open(wanted: &streaming::WantedStream) -> Result<Option<Self>, Failure> {
        let Some(server) = wanted.listen()? else { return Ok(None) };
        let mut url = server.url();
        let news = wanted.news(&url);
        if let Some(fingerprint) = server.fingerprint() {
            tell(&format!(
                "the stream's certificate is {fingerprint}: elsewhere, give it to `letoff dash \
                 --fingerprint`"
            ));
            url = format!("{url}#{fingerprint}");
        }
        let address = StreamAddress { url, token: wanted.owner() };
        Ok(Some(Self { server, address, news }))
    }

    fn serve(self, requests: &Arc<RequestHandler>) -> std::io::Result<ServedStream> {
        let Self { server, news, .. } = self;
        let (publisher, closer) = (server.publisher(), server.closer());
        let its = Arc::<RequestHandler>::clone(requests);
        let serving = tokio::spawn(telemetry::stream::serve(server, its));
        let status = StatusPublisher::start(requests, publisher.clone())?;
        Ok(ServedStream { publisher, closer, news, serving, status })
    }
}
