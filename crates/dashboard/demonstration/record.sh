#!/bin/sh
# Records demonstration.mcap, which `letoff-dashboard --demo` plays: demonstration.score on the keys
# of demonstration.toml, in virtual time. Needs `letoff` in the path.
set -eu
cd "$(dirname "$0")"
trap 'rm -f demonstration.mid' EXIT
python3 ../../../configs/performances/encode_score.py demonstration.score
rm -f demonstration.mcap
letoff run demonstration.toml --virtual-time --duration 4.5 --record demonstration.mcap \
    --listen none --black-box none
