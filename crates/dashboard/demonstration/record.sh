#!/bin/sh
# Records demonstration.mcap, which `letoff-dashboard --demo` plays: demonstration.score on the keys
# of demonstration.toml, in virtual time. Needs `letoff` in the path.
set -eu
cd "$(dirname "$0")"
trap 'rm -f demonstration.mid' EXIT
cargo run -p performance --example encode_score -- demonstration.score
rm -f demonstration.mcap
letoff run demonstration.toml --virtual-time --duration 4.5 --record demonstration.mcap \
    --listen none --black-box none
