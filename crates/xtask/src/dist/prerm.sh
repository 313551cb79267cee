#!/bin/sh
# Ends the service before its program goes: forces are ramped down, notes are ended.
set -e

if [ "$1" = remove ] && [ -d /run/systemd/system ]; then
	deb-systemd-invoke stop letoff.service >/dev/null || true
fi
