# Boards on USB: gadgets on one side, cdc_acm on the other. Sourced by checks.sh.

gadgets=/sys/kernel/config/usb_gadget

# plug N: puts the device N into its port.
plug() { echo "dummy_udc.$1" >"$gadgets/g$1/UDC"; }

# unplug N: pulls its cable.
unplug() { echo "" >"$gadgets/g$1/UDC"; }

# port N: the port by which the host reaches the device N, whatever it is called now.
port() {
	for tty in /sys/class/tty/ttyACM*; do
		if [ "$(cat "$tty/device/../serial")" = "letoff-$1" ]; then
			echo "/dev/${tty##*/}"
			return
		fi
	done
	return 1
}

# gadget N: a device with one serial port, /dev/ttyGSN on its own side, and a serial number.
gadget() {
	mkdir "$gadgets/g$1" && cd "$gadgets/g$1" || return
	echo 0x1209 >idVendor
	echo 0x0001 >idProduct
	mkdir -p strings/0x409 configs/c.1 functions/acm.usb0
	echo Letoff >strings/0x409/manufacturer
	echo "key board $1" >strings/0x409/product
	echo "letoff-$1" >strings/0x409/serialnumber
	ln -s functions/acm.usb0 configs/c.1/
	cd /tmp || return
	plug "$1"
	within 10 port "$1"
}

# board N NUMBER ARGUMENTS...: a board in the device N.
board() {
	n=$1
	number=$2
	shift 2
	boards "usb$n" --number "$number" --on "serial:/dev/ttyGS$n" "$@"
}

# way N: the host's way to the device N.
way() { echo "--link serial:$(port "$1")"; }

gadgets() {
	mount -t configfs none /sys/kernel/config
	for n in 0 1 2 3; do gadget $n; done
	letoff devices >devices.out 2>&1
	[ "$(grep -c 'key board . *, letoff-' devices.out)" = 4 ]
	verdict devices "letoff devices lists the USB boards by name and serial number" $? \
		"$(grep -A 1 ttyACM0 devices.out | tr '\n' ' ')"
}

# The piece on three of them; the third, where nobody plays, is pulled for a second.
# shellcheck disable=SC2046
unplugged() {
	board 0 3
	board 1 4
	board 2 5
	host unplugged $(way 0) $(way 1) $(way 2) --duration 8
	third=$(port 2)
	sleep 5
	unplug 2
	sleep 1
	plug 2
	ended
	jq '.boards |= map(select(.number != 5))' unplugged.json >unplugged.others.json
	one='.boards[] | select(.number == 5) | '
	[ $code = 0 ] && holds unplugged.others "$complete" && holds unplugged.others "$healthy" &&
		holds unplugged "$one"'.state == "armed" and .rearmed == 1' &&
		bear usb0 "$fresh" && bear usb1 "$fresh" && bear usb2 "$fresh"
	verdict unplugged "three boards on USB; one is unplugged for a second, and comes back" $? \
		"exit $code; $(notes unplugged); the others: $(links unplugged.others); the one, $third: $(
			of unplugged "$one"'"\(.missing) missing, rearmed \(.rearmed), \(.state)"'
		); $(graves usb2)"
}

# Ports that are no boards: one that says nothing, and one that says anything.
# shellcheck disable=SC2046
printers() {
	refused printer "a port that says nothing" "nothing on $(port 3) answers as a board does" \
		$(way 3)
	dd if=/dev/urandom bs=4096 count=4 of=/dev/ttyGS3 2>/dev/null &
	refused noise "a port that says anything" "nothing on $(port 3) answers as a board does" \
		$(way 3)
}
