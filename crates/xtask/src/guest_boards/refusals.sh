# Boards that may not be used. Sourced by checks.sh.

# refused NAME SENTENCE WORDS LINKS...: the host ends with exit code 1 and says the words; the
# boards are there already.
refused() {
	it=$1
	sentence=$2
	words=$3
	shift 3
	since=$(uptime)
	timeout 60 letoff run /scene.toml --json --performance none --duration 3 "$@" \
		>"$it.json" 2>"$it.err"
	code=$?
	bury
	[ $code = 1 ] && grep -q "$words" "$it.err"
	verdict "$it" "$sentence" $? "from $since s on, exit $code: $(head -n 3 "$it.err")"
}

major() {
	boards major --number 3 --on can:vcan0 --say-major 9
	refused major "a board of another generation" "board 3 on vcan0 speaks protocol 9" \
		--link can:vcan0
}

same_number() {
	boards one --number 3 --on can:vcan0 --say-uid 1
	boards other --number 3 --keys C4..E4 --on can:vcan0 --say-uid 2
	refused same_number "two boards with one number" "two boards say that they are board 3 on vcan0" \
		--link can:vcan0
}

all_refusals() {
	boards schema --number 3 --on can:vcan0 --say-schema 1
	refused schema "a board with other layouts" "board 3 on vcan0 was built with other cyclic layouts" \
		--link can:vcan0
	boards keys --number 3 --on can:vcan0 --say-keys 0,20
	refused keys "a board with twenty keys" "board 3 on vcan0 says that it carries" --link can:vcan0
	boards first --number 3 --on can:vcan0
	boards second --number 4 --keys C4..E4 --on can:vcan0
	refused overlap "two boards with one key" "both carry" --link can:vcan0
	refused nobody "a bus without a board" "nothing on vcan0 answers" --link can:vcan0
	refused nowhere "a bus that is not there" "the CAN interface vcan7 cannot be opened" \
		--link can:vcan7
}
