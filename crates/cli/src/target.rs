//! The scene of a command, with the overrides of the command line.

use boards::links::address::Address;
use clap::Args;

use super::Failure;
use super::arguments::{assignment, link_help};
use scene::{Boards, Library, LinksConfig, Override, Scene, link_overrides};

/// A scene, with other links or values than its own.
#[derive(Clone, Debug, Args)]
pub struct SceneTarget {
    /// A scene's name or file.
    #[arg(default_value = "default")]
    pub scene: String,
    /// Links instead of those of the scene.
    #[arg(long = "link", value_name = "LINK", help = link_help(), value_parser = Address::parse)]
    pub links: Vec<Address>,
    /// Any value of the scene, as `tick_hz=4000` or `links.bus.0.bit_rate=500000`.
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub set: Vec<(String, String)>,
}

impl SceneTarget {
    /// Returns all overrides of the scene, single values last.
    pub(super) fn overrides(&self) -> Vec<Override> {
        let set = self.set.iter().cloned().map(Override::from);
        link_overrides(&self.links).into_iter().chain(set).collect()
    }

    pub(super) fn load(&self) -> Result<Scene, Failure> {
        Scene::load_as_typed(&Library::default(), &self.scene, &self.overrides())
            .map_err(|diagnostics| Failure::Usage(diagnostics.to_string()))
    }

    pub(super) fn boards(&self) -> Result<(Scene, Boards), Failure> {
        let scene = self.load()?;
        let boards = match &scene.links {
            LinksConfig::Boards(boards) if !boards.buses.is_empty() => boards.clone(),
            LinksConfig::Boards(_) | LinksConfig::Simulated => {
                return Err(Failure::Usage(format!(
                    "the scene {:?} has no boards: give --link serial:PORT or --link can:INTERFACE, \
                     or a scene whose [links] have some",
                    scene.name
                )));
            }
        };
        Ok((scene, boards))
    }
}
