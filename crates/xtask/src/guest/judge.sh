# Goes through checks.sh beside it, which says on the console what it found. Lines that begin with
# CHECK and VERDICT are read by `cargo xtask`; everything else is for people.

checks=0
failed=0

uptime() { cut -d ' ' -f 1 /proc/uptime; }

# verdict NAME SENTENCE RESULT DETAIL: RESULT is 0 if the sentence holds.
verdict() {
	checks=$((checks + 1))
	if [ "$3" = 0 ]; then
		echo "CHECK passed  $(uptime) s: $2 ($4)"
	else
		failed=$((failed + 1))
		echo "CHECK FAILED  $(uptime) s: $2 ($4)"
		for file in "$1".*; do
			echo "--- $file" && tail -n 40 "$file"
		done
	fi
}

# within SECONDS COMMAND...: waits until COMMAND succeeds; fails if it does not in time.
within() {
	tries=$(($1 * 5))
	shift
	until "$@" >/dev/null 2>&1; do
		tries=$((tries - 1))
		[ $tries -gt 0 ] || return 1
		sleep 0.2
	done
}

. "$guest/checks.sh"

echo "VERDICT $failed of $checks checks failed, after $(uptime) s"
