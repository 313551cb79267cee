# Plays boards over real drivers, breaks what can break, and says what became of it.

form=$(cat /form)
. /play.sh
. /can.sh
. /fates.sh
. /refusals.sh
. /usb.sh

interface vcan0 72
interface vcan1 16

# The kernel's arguments say which part is this guest's.
case "$form, $part" in
"full, bus")
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
	strangers
	forged
	classic
	load
	;;
"full, fates")
	down
	removed
	killed
	another
	die
	all_fates
	major
	same_number
	all_refusals
	gadgets
	unplugged
	printers
	;;
"short, bus")
	conformance
	piece
	rate 5
	loss
	two_periods
	major
	same_number
	;;
"short, fates")
	down
	killed
	die
	gadgets
	unplugged
	;;
*) verdict part "the part of the checks is known" 1 "$form, $part" ;;
esac
