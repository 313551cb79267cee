/* Fault rig: the reference firmware as a program, with keys that have motors, and with faults. */
#include "encoder.h"
#include "faults.h"
#include "finger.h"
#include "machine.h"
#include "session.h"
#include "wire.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SECOND_US 1000000u
/* Largest latency [us], and longest time before faults [s]. */
#define MAX_LATENCY_US 1e6
#define MAX_FROM_S 1e6

static const char usage[] =
    "Usage: rig [options]\n"
    "\n"
    "  --lockstep        run in virtual time over stdin and stdout\n"
    "  --link PATH       make a link to the terminal\n"
    "  --finger SCRIPT   none, slow, mixed (default) or hold\n"
    "  --fault NAME[=X]  add a fault; may be repeated\n"
    "  --from S          let faults begin this long after the first Arm; 0 is from power on\n"
    "  --latency US      latency of the link, each way\n"
    "  --seed N          seed of everything random, 1 by default\n"
    "  --report FILE     write a report each second and at the end\n"
    "  --faults          print all faults\n"
    "  --help            print this help\n";

static uint64_t reported_us;

void session_begin(const struct settings *settings, uint64_t now_us)
{
    reported_us = now_us;
    wire_begin(settings->seed, settings->latency_us);
    encoders_begin(settings->seed);
    machine_begin(now_us, settings->from_s);
}

bool session_report(const struct settings *settings)
{
    struct board_account board = machine_account();
    board.seed = settings->seed;
    return settings->report == NULL || report_write(settings->report, &board);
}

void session_report_each_second(const struct settings *settings, uint64_t now_us)
{
    if (SECOND_US <= now_us - reported_us) {
        reported_us = now_us;
        (void)session_report(settings);
    }
}

/* Reads a number from 0 to `most`; returns `false` if there is none. */
static bool take_number(const char *text, double most, double *number)
{
    char *end;
    *number = strtod(text, &end);
    return end != text && *end == 0 && 0.0 <= *number && *number <= most;
}

static bool take_seed(const char *text, uint64_t *seed)
{
    char *end;
    *seed = strtoull(text, &end, 10);
    return end != text && *end == 0 && text[0] != '-';
}

static bool take_option(struct settings *settings, const char **finger, const char *name,
                        const char *value)
{
    double number = 0.0;
    if (strcmp(name, "--finger") == 0) {
        *finger = value;
    } else if (strcmp(name, "--fault") == 0) {
        return faults_add(value);
    } else if (strcmp(name, "--from") == 0 && take_number(value, MAX_FROM_S, &number)) {
        settings->from_s = number;
    } else if (strcmp(name, "--latency") == 0 && take_number(value, MAX_LATENCY_US, &number)) {
        settings->latency_us = (uint64_t)number;
    } else if (strcmp(name, "--seed") == 0 && take_seed(value, &settings->seed)) {
        return true;
    } else if (strcmp(name, "--report") == 0) {
        settings->report = value;
    } else if (strcmp(name, "--link") == 0) {
        settings->link = value;
    } else {
        fprintf(stderr, "rig: invalid argument \"%s %s\"; try \"rig --help\"\n", name, value);
        return false;
    }
    return true;
}

static bool take_arguments(struct settings *settings, int argc, char **argv)
{
    const char *finger = "mixed";
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--lockstep") == 0) {
            settings->lockstep = true;
        } else if (i + 1 == argc) {
            fprintf(stderr, "rig: invalid argument \"%s\"; try \"rig --help\"\n", argv[i]);
            return false;
        } else if (!take_option(settings, &finger, argv[i], argv[i + 1])) {
            return false;
        } else {
            i++;
        }
    }
    if (!finger_begin(finger, settings->seed)) {
        fprintf(stderr, "rig: unknown script \"%s\", expected none, slow, mixed or hold\n", finger);
        return false;
    }
    return true;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "--help") == 0) {
        fputs(usage, stdout);
        return 0;
    }
    if (argc == 2 && strcmp(argv[1], "--faults") == 0) {
        faults_print();
        return 0;
    }
    struct settings settings = {.seed = 1};
    if (!take_arguments(&settings, argc, argv)) {
        return 2;
    }
    return settings.lockstep ? run_lockstep(&settings) : run_terminal(&settings);
}
