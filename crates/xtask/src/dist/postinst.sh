#!/bin/sh
# Makes the user and the groups, and lets udev see its rules. A service that is new is enabled only
# if there is a scene for it; one that was there keeps its state, and is restarted if it plays.
set -e

case "$1" in
configure | abort-upgrade | abort-deconfigure | abort-remove)
	systemd-sysusers letoff.conf

	if [ -d /run/udev ]; then
		udevadm control --reload || true
		udevadm trigger --action=change --subsystem-match=usb-serial || true
		udevadm trigger --action=change --subsystem-match=net --attr-match=type=280 || true
	fi

	if deb-systemd-helper debian-installed letoff.service; then
		if deb-systemd-helper --quiet was-enabled letoff.service; then
			deb-systemd-helper enable letoff.service >/dev/null || true
		fi
	elif [ -e /etc/letoff/scene.toml ]; then
		deb-systemd-helper enable letoff.service >/dev/null || true
	fi
	deb-systemd-helper update-state letoff.service >/dev/null || true

	if [ -d /run/systemd/system ]; then
		systemctl --system daemon-reload >/dev/null || true
		if deb-systemd-helper --quiet is-enabled letoff.service && [ -z "$2" ]; then
			deb-systemd-invoke start letoff.service >/dev/null || true
		elif [ -n "$2" ]; then
			deb-systemd-invoke try-restart letoff.service >/dev/null || true
		fi
	fi
	;;
esac
