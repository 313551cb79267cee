/* Virtual time: each exchange carries the time of the host, so two runs are alike bit by bit. */
#include "../letoff_protocol.h"
#include "machine.h"
#include "session.h"
#include "wire.h"

#include <stdio.h>

#define TIME_LEN 8u
#define LENGTH_LEN 2u
#define HEAD_LEN (TIME_LEN + LENGTH_LEN)
#define MAX_BYTES 65535u

enum reading { READING_WHOLE = 0, READING_END, READING_CUT };

static enum reading read_exchange(uint64_t *now_us, uint8_t *bytes, size_t *len)
{
    uint8_t head[HEAD_LEN];
    size_t n = fread(head, 1, sizeof head, stdin);
    if (n < sizeof head) {
        return n == 0 ? READING_END : READING_CUT;
    }
    *now_us = letoff_take(head, TIME_LEN);
    *len = (size_t)letoff_take(head + TIME_LEN, LENGTH_LEN);
    return fread(bytes, 1, *len, stdin) == *len ? READING_WHOLE : READING_CUT;
}

/* Answers with all that has arrived at the host. */
static bool answer(void)
{
    static uint8_t bytes[LENGTH_LEN + MAX_BYTES];
    size_t len = 0;
    const struct packet *packet = wire_to_host(MAX_BYTES);
    while (packet != NULL) {
        memcpy(bytes + LENGTH_LEN + len, packet->bytes, packet->len);
        len += packet->len;
        packet = wire_to_host(MAX_BYTES - len);
    }
    letoff_put(bytes, len, LENGTH_LEN);
    return fwrite(bytes, 1, LENGTH_LEN + len, stdout) == LENGTH_LEN + len && fflush(stdout) == 0;
}

int run_lockstep(const struct settings *settings)
{
    static uint8_t bytes[MAX_BYTES];
    enum reading reading;
    uint64_t now_us = 0;
    uint64_t before_us = 0;
    size_t len = 0;
    bool begun = false;
    bool answered = true;
    while (answered && (reading = read_exchange(&now_us, bytes, &len)) == READING_WHOLE) {
        if (!begun) {
            session_begin(settings, now_us);
            begun = true;
        } else if (now_us < before_us) {
            fprintf(stderr, "rig: time runs backwards\n");
            break;
        }
        before_us = now_us;
        machine_receive(bytes, len);
        machine_run(now_us, true);
        session_report_each_second(settings, now_us);
        answered = answer();
    }
    bool reported = session_report(settings);
    return reported && answered && reading == READING_END ? 0 : 1;
}
