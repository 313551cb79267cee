//! Makes the messages' types, and the descriptors that viewers read, from their description.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use protox::prost::Message as _;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=proto");
    let mut files = protox::compile(["letoff/telemetry.proto"], ["proto"])?;
    let out = PathBuf::from(std::env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    prost_build::Config::new().compile_fds(files.clone())?;
    // Every recording has them a dozen times: without the comments, which are three quarters.
    for file in &mut files.file {
        file.source_code_info = None;
    }
    fs::write(out.join("telemetry.binpb"), files.encode_to_vec())?;
    Ok(())
}
