//! `letoff set`: changes settings of `[render]` in the running host.

use std::io::Write;

use clap::Args;

use super::{Failure, arguments, ask};
use host::control::Request;
use telemetry::request::RenderSetting;

/// Settings for the running host.
#[derive(Debug, Args)]
pub struct SetArgs {
    /// Settings as a scene has them: render.passivity=control, render.coupling_stiffness="400 N/m".
    #[arg(value_name = "NAME=VALUE", required = true, value_parser = arguments::assignment)]
    settings: Vec<(String, String)>,
}

pub(super) fn run(args: &SetArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let setting = |(name, value): &(String, String)| RenderSetting {
        name: name.clone(),
        value: value.clone(),
    };
    let settings = args.settings.iter().map(setting).collect();
    ask::ask(&Request::Render { settings }, Failure::Usage, out)
}
