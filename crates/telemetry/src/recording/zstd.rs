//! Decompression of zstd, which other programs may use: the recorder itself uses lz4.

use std::{fmt::Display, io::Read as _};

use mcap::sans_io::decompressor::{DecompressResult, Decompressor};
use mcap::{McapError, McapResult};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};

/// Input with which the decoder can always continue (B): largest block, its and its frame's header.
const READ: usize = 128 * 1024 + 3 + 18;

#[derive(Default)]
pub(super) struct Zstd {
    decoder: FrameDecoder,
    is_inside: bool,
}

impl Decompressor for Zstd {
    fn next_read_size(&self) -> usize {
        READ
    }

    fn decompress(&mut self, src: &[u8], dst: &mut [u8]) -> McapResult<DecompressResult> {
        let mut rest = src;
        if !self.is_inside {
            self.decoder.reset(&mut rest).map_err(damaged)?;
            self.is_inside = true;
        }
        if self.decoder.can_collect() == 0 && !self.decoder.is_finished() {
            // One block at a time: a few bytes can expand to a great many.
            let one = BlockDecodingStrategy::UptoBlocks(1);
            self.decoder.decode_blocks(&mut rest, one).map_err(damaged)?;
        }
        let wrote = self.decoder.read(dst)?;
        // A chunk may be several frames.
        self.is_inside = !self.decoder.is_finished() || self.decoder.can_collect() > 0;
        Ok(DecompressResult { consumed: src.len() - rest.len(), wrote })
    }

    fn reset(&mut self) -> McapResult<()> {
        self.is_inside = false;
        Ok(())
    }

    fn name(&self) -> &'static str {
        "zstd"
    }
}

fn damaged(error: impl Display) -> McapError {
    McapError::DecompressionError(error.to_string())
}
