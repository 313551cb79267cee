#include "faults.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct description {
    const char *name;
    /* Unit of the value; NULL if the fault has no value. */
    const char *unit;
    double usual;
    double least;
    double most;
    const char *meaning;
};

static const struct description descriptions[FAULT_COUNT] = {
    [FAULT_HALF] = {"half", "frames", 2, 2, 100,
                    "Confirms the period of Stream and sends every n-th frame, without a gap in "
                    "the numbers: a loop that is slower than promised."},
    [FAULT_BURST] = {"burst", "ms", 16, 1, 1000,
                     "Bytes to the host wait and arrive together at the end of each interval: the "
                     "latency timer of an FTDI chip."},
    [FAULT_LATENCY] = {"latency", "us", 2000, 0, 1e6,
                       "Bytes take longer, each way: a hub, a bridge, a radio link."},
    [FAULT_JITTER] = {"jitter", "us", 2000, 0, 1e6,
                      "Bytes take up to this much longer, each way, at random: a busy bus."},
    [FAULT_DROP] = {"drop", "share", 0.3, 0, 1,
                    "Frames to the host are lost at random: a full buffer, a bad cable."},
    [FAULT_DROPDOWN] = {"dropdown", "share", 0.3, 0, 1,
                        "Frames from the host are lost at random: a slow receiver."},
    [FAULT_CORRUPT] = {"corrupt", "share", 5e-4, 0, 1,
                       "Bits are inverted at random, both ways: EMI, a wrong baud rate."},
    [FAULT_ECHO] = {"echo", NULL, 0, 0, 0,
                    "The host receives its own bytes: half-duplex wiring."},
    [FAULT_TEXT] = {"text", "frames", 16, 1, 1e6,
                    "Text stands in front of each n-th frame: printf on the port of the link."},
    [FAULT_BOOTTEXT] = {"boottext", NULL, 0, 0, 0,
                        "A boot log stands in front of the hello: the boot loader of an ESP32."},
    [FAULT_REPEAT] = {"repeat", NULL, 0, 0, 0, "Each frame to the host arrives twice: a bridge."},
    [FAULT_WRONGLEN] = {"wronglen", NULL, 0, 0, 0,
                        "All frames of forces have a wrong length for the board, which counts them "
                        "as refused: a CRC that is left on, another number of keys."},
    [FAULT_STALE] = {"stale", NULL, 0, 0, 0,
                     "The board forgets its samples at once, and counts all forces as stale: a "
                     "history that is too short."},
    [FAULT_DRIFT] = {"drift", "ppm", 2000, -1e5, 1e5,
                     "The clock of the board is too fast by this: an RC oscillator."},
    [FAULT_OLDMINOR] = {"oldminor", "minor", 0, 0, 255,
                        "The hello has this minor number, and below 2 the board knows none of the "
                        "requests of 2.2: older firmware."},
    [FAULT_MOTORSIGN] = {"motorsign", NULL, 0, 0, 0, "The motor pushes the other way: its wires "
                                                     "are exchanged."},
    [FAULT_DEADMOTOR] = {"deadmotor", NULL, 0, 0, 0, "The motor has no current: a broken wire."},
    [FAULT_WEAK] = {"weak", "factor", 0.5, 0, 2,
                    "The motor has this fraction of its force: a hot magnet, a low supply."},
    [FAULT_STUCK] = {"stuck", "N", 8, -30, 30,
                     "The amplifier ignores its command and pushes the key down by this, up if the "
                     "value is negative: a shorted transistor."},
    [FAULT_SLOWMOTOR] = {"slowmotor", "Hz", 30, 0.1, 1000,
                         "The current follows with this bandwidth: a mistuned loop."},
    [FAULT_COGGING] = {"cogging", "N", 0.15, 0, 10,
                       "A force of this amplitude depends on the place, with a period of 1.2 mm: "
                       "iron in the motor."},
    [FAULT_MUTELIES] = {"mutelies", NULL, 0, 0, 0,
                        "MuteKey is done and changes nothing: unfinished firmware."},
    [FAULT_ENCSIGN] = {"encsign", NULL, 0, 0, 0,
                       "Positions and velocities have the other sign: a turned sensor."},
    [FAULT_SCALE] = {"scale", "factor", 2, -10, 10,
                     "Positions and velocities are multiplied: a wrong quantum in the hello."},
    [FAULT_SPIKE] = {"spike", "um", 300, -1e5, 1e5,
                     "One sample in 50, at random, is this much deeper: EMI, a dropped edge."},
    [FAULT_BIGSPIKE] = {"bigspike", "um", 2000, -1e5, 1e5, "Like `spike`, but larger."},
    [FAULT_SHIFT] = {"shift", "um", 1000, -1e5, 1e5,
                     "Positions are deeper by this from the start of the fault on: a lost index, a "
                     "slipping coupling."},
    [FAULT_NOISE] = {"noise", "um", 20, 0, 1e4,
                     "Each reading is off by up to this, either way: an analogue sensor."},
    [FAULT_FROZEN] = {"frozen", NULL, 0, 0, 0,
                      "The encoder reads the place where the key was when the fault began: a "
                      "stopped sensor."},
    [FAULT_JUMPY] = {"jumpy", "um", 2000, -1e5, 1e5,
                     "Samples alternate between that place and one that is this much deeper: a "
                     "loose plug."},
    [FAULT_VELSIGN] = {"velsign", NULL, 0, 0, 0, "Velocities have the other sign."},
    [FAULT_VELZERO] = {"velzero", NULL, 0, 0, 0, "Velocities are 0: an unfinished estimator."},
    [FAULT_VELSCALE] = {"velscale", "factor", 2, -100, 100,
                        "Velocities are multiplied: a wrong unit."},
    [FAULT_HOT] = {"hot", NULL, 0, 0, 0,
                   "BoardHealth names the key as failed, KeyHealth has 325 °C; the board can "
                   "still be armed: firmware that reports and does not act."},
    [FAULT_OVERHEAT] = {"overheat", "°C", 150, 50, 400,
                        "Like `hot`, but the temperature approaches this value with 1 s."},
    [FAULT_KEYFAULT] = {"keyfault", NULL, 0, 0, 0,
                        "The board latches KEY_FAULT, and its log has \"key 0: too hot\"."},
    [FAULT_NOTHOMED] = {"nothomed", NULL, 0, 0, 0, "The encoder does not know its place."},
    [FAULT_BROWN] = {"brown", "N", 3, 0, 1000,
                     "The supply fails when the forces of all keys together are larger than this. "
                     "The board is dark for 0.3 s and restarts with reset reason 2."},
    [FAULT_RESTART] = {"restart", "s", 5, 0.1, 1e6,
                       "The board restarts when it has run for this time, with reset reason 3: its "
                       "watchdog expired."},
    [FAULT_HANG] = {"hang", "s", 0.5, 0, 1.9,
                    "The loop stops for this time every 2 s, while the interrupt of the law "
                    "continues: a blocking write."},
};

static struct {
    bool added;
    double value;
} chosen[FAULT_COUNT];

static bool any;
static bool began;
static uint64_t began_us;

static int find(const char *name, size_t len)
{
    for (int fault = 0; fault < FAULT_COUNT; fault++) {
        const char *known = descriptions[fault].name;
        if (strlen(known) == len && memcmp(known, name, len) == 0) {
            return fault;
        }
    }
    return -1;
}

bool faults_add(const char *text)
{
    size_t len = strcspn(text, "=");
    int fault = find(text, len);
    if (fault < 0) {
        fprintf(stderr, "rig: unknown fault \"%s\"; \"rig --faults\" prints all of them\n", text);
        return false;
    }
    const struct description *known = &descriptions[fault];
    double value = known->usual;
    if (text[len] == '=') {
        char *end;
        value = strtod(text + len + 1, &end);
        /* NaN fails the comparisons. */
        if (known->unit == NULL || end == text + len + 1 || *end != 0 ||
            !(known->least <= value && value <= known->most)) {
            fprintf(stderr, "rig: invalid value in \"%s\", expected %s\n", text,
                    known->unit == NULL ? "none" : "one within the limits of the fault");
            return false;
        }
    }
    chosen[fault].added = true;
    chosen[fault].value = value;
    any = true;
    return true;
}

void faults_print(void)
{
    for (size_t i = 0; i < FAULT_COUNT; i++) {
        const struct description *fault = &descriptions[i];
        if (fault->unit == NULL) {
            printf("| `%s` | | %s |\n", fault->name, fault->meaning);
        } else {
            printf("| `%s` | %g %s | %s |\n", fault->name, fault->usual, fault->unit,
                   fault->meaning);
        }
    }
}

const char *faults_name(enum fault fault)
{
    return chosen[fault].added ? descriptions[fault].name : NULL;
}

void faults_begin(uint64_t now_us)
{
    began = any;
    began_us = now_us;
}

bool faults_began(void)
{
    return began;
}

double faults_age(uint64_t now_us)
{
    return 1e-6 * (double)(now_us - began_us);
}

bool fault_is_on(enum fault fault)
{
    return began && chosen[fault].added;
}

double fault_value(enum fault fault)
{
    return chosen[fault].value;
}
