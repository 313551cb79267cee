//! Which boards are meant: those of a scene, or those behind links.

use clap::Args;
use hardware::link::address::Address;

use super::Failure;
use crate::config::{Boards, Links, Scene, link_overrides};

/// A scene, or links instead of its own.
#[derive(Clone, Debug, Args)]
pub struct Target {
    /// A scene's name or file.
    #[arg(default_value = "default")]
    pub scene: String,
    /// Links instead of those of the scene: serial:PORT[@BAUD], can:INTERFACE or
    /// classic-can:INTERFACE; once for each.
    #[arg(long = "link", value_name = "LINK", value_parser = Address::parse)]
    pub links: Vec<Address>,
}

impl Target {
    /// The scene's rate [Hz], and its boards.
    pub(super) fn boards(&self) -> Result<(u32, Boards), Failure> {
        let scene = Scene::load(&self.scene, &link_overrides(&self.links))
            .map_err(|diagnostics| Failure::Usage(diagnostics.to_string()))?;
        match scene.links {
            Links::Boards(boards) if !boards.buses.is_empty() => Ok((scene.tick_hz, boards)),
            Links::Boards(_) | Links::Simulated => Err(Failure::Usage(format!(
                "the scene {:?} has no boards: give --link serial:PORT or --link can:INTERFACE, \
                 or a scene whose [links] have some",
                scene.name
            ))),
        }
    }
}
