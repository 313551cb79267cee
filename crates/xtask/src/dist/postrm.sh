#!/bin/sh
# Removing leaves what is not the package's: the scene, calibrations and recordings. Purging
# takes them too, with the user and the groups; realtime stays if somebody else is in it.
set -e

if [ "$1" = remove ] && [ -d /run/systemd/system ]; then
	systemctl --system daemon-reload >/dev/null || true
fi

# The service keeps it between two runs.
rm -rf /run/letoff

if [ "$1" = purge ]; then
	if command -v deb-systemd-helper >/dev/null; then
		deb-systemd-helper purge letoff.service >/dev/null || true
	fi
	rm -rf /etc/letoff /var/lib/letoff
	if getent passwd letoff >/dev/null; then
		userdel letoff || true
	fi
	if getent group letoff >/dev/null; then
		groupdel letoff || true
	fi
	case "$(getent group realtime)" in
	realtime:*:) groupdel realtime || true ;;
	esac
fi
