//! SIGHUP: the scene's file is read again while the host plays.

use std::io::{self, IsTerminal as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use telemetry::log::Level;
use tokio::sync::Mutex;

use super::log::LogLines;
use super::service;
use super::signals::HangUp;
use super::supervisor_args::SupervisorArgs;
use host::control::RequestHandler;
use scene::{Library, Override, Scene};

/// The file of a scene, and what the command line changes of it.
#[derive(Clone, Debug)]
pub(super) struct SceneFile {
    path: PathBuf,
    overrides: Vec<Override>,
    supervisor: SupervisorArgs,
    library: Library,
    /// Held while it is read, so that the last reading is the one that stays.
    turn: Arc<Mutex<()>>,
}

impl SceneFile {
    /// Returns the file of the scene that was typed with `overrides`; none of a scene that is part
    /// of the program.
    pub(super) fn of(
        typed: &str,
        overrides: Vec<Override>,
        supervisor: SupervisorArgs,
    ) -> Option<Self> {
        let is_there = Path::new(typed).is_file() || supervisor.last_scene().is_some();
        let is_file = is_there && !scene::scenes().any(|it| it == typed);
        let (path, library) = (PathBuf::from(typed), Library::default());
        let turn = Arc::default();
        is_file.then_some(Self { path, overrides, supervisor, library, turn })
    }

    /// Reads it for a host that begins, or what the host before a crash has taken of it; returns
    /// the text as well.
    pub(super) fn begin(&self) -> Result<(Scene, String), String> {
        self.supervisor.last_scene().map_or_else(|| self.read(), |text| self.scene(text))
    }

    fn read(&self) -> Result<(Scene, String), String> {
        let text = Scene::file_text(&self.path).map_err(|wrong| wrong.to_string())?;
        self.scene(text)
    }

    fn scene(&self, text: String) -> Result<(Scene, String), String> {
        let scene = Scene::from_file_text(&self.library, &self.path, text.clone(), &self.overrides);
        scene.map(|scene| (scene, text)).map_err(|wrong| wrong.to_string())
    }

    /// Reads the file again, and lets what can change live play; `log` hears what came of it.
    pub(super) async fn reload(self, requests: Arc<RequestHandler>, log: LogLines) {
        let _turn = Arc::clone(&self.turn).lock_owned().await;
        service::reloading();
        let read = move || {
            let (scene, text) = self.read().map_err(|wrong| {
                format!("the scene is wrong, and the one that plays goes on:\n{wrong}")
            })?;
            let said = requests.reload(scene, "SIGHUP")?;
            self.supervisor.keep_scene(&text);
            Ok(said)
        };
        // Voices are built: not on the thread that hears signals.
        let done = tokio::task::spawn_blocking(read).await;
        match done.unwrap_or_else(|panic| Err(panic.to_string())) {
            // The log hears of it as of any other change.
            Ok(text) => service::reloaded(&text),
            Err(text) => {
                service::reloaded(&text);
                log.say(Level::Error, text);
            }
        }
    }
}

/// Returns what a hang-up means to a run: the scene of a `file` is read again, but a terminal that
/// is closed ends what runs in it.
pub(super) fn meaning(file: Option<&SceneFile>) -> HangUp {
    let has_terminal = io::stdin().is_terminal() || io::stderr().is_terminal();
    match file {
        Some(_) if !has_terminal => HangUp::Reloads,
        Some(_) | None => HangUp::Ends,
    }
}
