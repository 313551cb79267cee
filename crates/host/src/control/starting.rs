//! Answers of the control socket from the start of a host.

use std::sync::{Arc, OnceLock};
use std::time::Duration;

use scene::Scene;
use telemetry::{Reply, Request};

use super::{Answer, Answers, Folders, RequestHandler, RunHandle, StreamAddress};

const LOOK: Duration = Duration::from_millis(20);

/// Polls before the host answers "try again": 3 s, shorter than the client's timeout.
const MOST_LOOKS: u32 = 150;

pub const STARTING: &str = "the host is starting, and tries its keys: ask again in a moment";

/// Answers for a host that still tries its keys: stop and status at once, other requests when its
/// scene is known and its stream listens.
#[derive(Debug)]
pub struct StartingHost {
    run: Arc<RunHandle>,
    requests: OnceLock<Arc<RequestHandler>>,
}

impl StartingHost {
    pub const fn new(run: Arc<RunHandle>) -> Self {
        Self { run, requests: OnceLock::new() }
    }

    /// Starts to answer all requests, for a host that runs `scene` with this `stream`; clients of
    /// the stream name files in `folders`.
    pub fn begin(
        &self,
        scene: Scene,
        folders: Folders,
        stream: Option<StreamAddress>,
    ) -> Arc<RequestHandler> {
        let run = Arc::clone(&self.run);
        let make = || Arc::new(RequestHandler::with_stream(scene, run, folders, stream));
        Arc::clone(self.requests.get_or_init(make))
    }

    fn wait(&self) -> Option<&Arc<RequestHandler>> {
        (0..MOST_LOOKS).find_map(|_look| {
            std::thread::sleep(LOOK);
            self.requests.get()
        })
    }
}

impl Answers for StartingHost {
    fn reply_to(&self, request: &Request, connection: u64) -> Answer {
        match (self.requests.get(), request) {
            (Some(requests), _) => requests.reply_to(request, connection),
            (None, Request::Stop {}) => self.run.emergency.reply_to(request, connection),
            (None, Request::Status {}) => {
                Ok(Reply::Status { status: Box::new(self.run.status.examine()) })
            }
            (None, _too_early) => self.wait().ok_or(STARTING)?.reply_to(request, connection),
        }
    }

    fn left(&self, connection: u64) {
        if let Some(requests) = self.requests.get() {
            requests.left(connection);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn while_keys_are_tried_status_is_told_and_all_else_waits_for_the_scene() {
        let starting = StartingHost::new(Arc::default());
        let state = starting.reply_to(&Request::Status {}, 1);
        assert!(matches!(state, Ok(Reply::Status { .. })), "{state:?}");
        std::thread::scope(|scope| {
            let told = scope.spawn(|| starting.reply_to(&Request::Scene {}, 1));
            let springs = Scene::load(&scene::Library::default(), "springs", &[]).unwrap();
            let _requests = starting.begin(springs, Folders::default(), None);
            let told = told.join().unwrap();
            assert!(matches!(told, Ok(Reply::Scene { .. })), "{told:?}");
        });
    }

    #[test]
    fn the_first_answer_names_the_stream() {
        let starting = StartingHost::new(Arc::default());
        let (url, token) = ("ws://127.0.0.1:8765".to_owned(), Some("secret".to_owned()));
        std::thread::scope(|scope| {
            let reply = scope.spawn(|| starting.reply_to(&Request::Where {}, 1));
            let springs = Scene::load(&scene::Library::default(), "springs", &[]).unwrap();
            let stream = StreamAddress { url: url.clone(), token: token.clone() };
            let _requests = starting.begin(springs, Folders::default(), Some(stream));
            assert_eq!(reply.join().unwrap(), Ok(Reply::Where { address: url, token }));
        });
    }
}
