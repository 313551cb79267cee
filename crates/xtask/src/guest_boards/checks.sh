# Plays boards over real drivers, breaks what can break, and says what became of it.

form=$(cat /form)
. /play.sh
. /can.sh
. /fates.sh
. /refusals.sh
. /usb.sh

interface vcan0 72
interface vcan1 16

if [ "$form" = full ]; then
	conformance
	piece
	rate 60
	loss
	late
	two_periods
	too_late
	corrupt
	full
	errors
	down
	removed
	killed
	another
	die
	all_fates
	major
	same_number
	all_refusals
	classic
	strangers
	forged
	gadgets
	unplugged
	printers
	load
else
	conformance
	piece
	rate 5
	loss
	two_periods
	down
	killed
	die
	major
	same_number
	gadgets
	unplugged
fi
