//! The scene's file, read at the start and at SIGHUP, and its last accepted copy.

use std::fs;
use std::io::{self, IsTerminal as _};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use documents::shown;
use telemetry::log::Level;
use tokio::sync::Mutex;

use super::log::{LogLines, tell_as};
use super::service;
use super::signals::HangUp;
use super::tell;
use host::control::RequestHandler;
use scene::{Library, Override, Scene};

/// File of a scene, with the command line's overrides.
#[derive(Clone, Debug)]
pub(super) struct SceneFile {
    path: PathBuf,
    overrides: Vec<Override>,
    library: Library,
    /// File with the last accepted text, if it is kept.
    last: Option<PathBuf>,
    /// Held while the scene is read, so that the last reading wins.
    turn: Arc<Mutex<()>>,
}

impl SceneFile {
    /// Returns the file of the scene `typed`; `None` for a built-in scene.
    pub(super) fn of(typed: &str, overrides: Vec<Override>, last: Option<PathBuf>) -> Option<Self> {
        let exists = Path::new(typed).is_file() || last.as_deref().is_some_and(Path::is_file);
        let is_file = exists && !scene::scenes().any(|it| it == typed);
        let (path, library) = (PathBuf::from(typed), Library::default());
        let turn = Arc::default();
        is_file.then_some(Self { path, overrides, library, last, turn })
    }

    /// Returns the initial scene with its text: that accepted before a crash, or that of the file.
    pub(super) fn begin(&self) -> Result<(Scene, String), String> {
        let Some(last) = self.last.as_ref().filter(|last| last.is_file()) else {
            return self.read();
        };
        let text = fs::read_to_string(last);
        let text = text.map_err(|error| format!("{}: {error}", shown(last)))?;
        tell_as(
            Level::Warning,
            &format!(
                "the host before did not end in good order: {} has the scene that it played, and \
                 {} is read at the next SIGHUP",
                shown(last),
                shown(&self.path)
            ),
        );
        self.scene(text)
    }

    /// Stores the accepted `text`, so that a restart after a crash needs no file under editing.
    pub(super) fn keep(&self, text: &str) {
        let Some(last) = &self.last else { return };
        let part = last.with_extension("part");
        if let Err(error) = fs::write(&part, text).and_then(|()| fs::rename(&part, last)) {
            let (last, path) = (shown(last), shown(&self.path));
            tell(&format!("{last}: {error}; after a crash {path} would be read again"));
        }
    }

    fn read(&self) -> Result<(Scene, String), String> {
        let text = Scene::file_text(&self.path).map_err(|wrong| wrong.to_string())?;
        self.scene(text)
    }

    fn scene(&self, text: String) -> Result<(Scene, String), String> {
        let scene = Scene::from_file_text(&self.library, &self.path, text.clone(), &self.overrides);
        scene.map(|scene| (scene, text)).map_err(|wrong| wrong.to_string())
    }

    /// Reads the file again and applies the live changes; `log` reports the result.
    pub(super) async fn reload(self, requests: Arc<RequestHandler>, log: LogLines) {
        let _turn = Arc::clone(&self.turn).lock_owned().await;
        service::reloading();
        let read = move || {
            let (scene, text) = self.read().map_err(|wrong| {
                format!("the scene is wrong, and the one that plays goes on:\n{wrong}")
            })?;
            let said = requests.reload(scene, "SIGHUP")?;
            self.keep(&text);
            Ok(said)
        };
        // Voices are built here, so not on the thread that receives signals.
        let done = tokio::task::spawn_blocking(read).await;
        match done.unwrap_or_else(|panic| Err(panic.to_string())) {
            Ok(text) => service::reloaded(&text),
            Err(text) => {
                service::reloaded(&text);
                log.say(Level::Error, text);
            }
        }
    }
}

/// Returns the meaning of a hang-up: reload for a scene with a `file`, end for a closed terminal.
pub(super) fn meaning(file: Option<&SceneFile>) -> HangUp {
    let has_terminal = io::stdin().is_terminal() || io::stderr().is_terminal();
    match file {
        Some(_) if !has_terminal => HangUp::Reloads,
        Some(_) | None => HangUp::Ends,
    }
}
