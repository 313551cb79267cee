#include "finger.h"

#include "random.h"

#include <math.h>

#define TURN 6.283185307179586
/* Half of the travel, and its end [m]. */
#define MIDDLE 5.08e-3
#define BOTTOM 10.16e-3
/* `slow`: amplitude [m] and frequency [Hz]. */
#define SLOW_WAY 6e-3
#define SLOW_HZ 0.5
/* `hold`: time of contact [s], speed [m/s], and depth beyond the bottom [m]: 8 N over the finger of
 * 400 N/m and its pulp of 4000 N/m. */
#define HOLD_FROM 1.0
#define HOLD_SPEED 0.1
#define HOLD_BEYOND 22e-3
/* Physiological tremor: frequency [Hz], amplitude [m], and its wander in a step [rad]. */
#define TREMOR_HZ 9.0
#define TREMOR 30e-6
#define WANDER 0.02
#define STEP 1e-4
#define CYCLE_US 6000000u

enum script { SCRIPT_NONE = 0, SCRIPT_SLOW, SCRIPT_MIXED, SCRIPT_HOLD, SCRIPT_COUNT };

static const char *const names[SCRIPT_COUNT] = {"none", "slow", "mixed", "hold"};

/* `mixed`, by start: touch, start and release [us], speed [um/s], hold and start depth [um], lift
 * [us]. A finger that is held 16.5 mm beyond the bottom presses with 6 N. */
static const struct letoff_finger mixed[] = {
    /* Rests lightly. */
    {0, LETOFF_FINGER_PRESSED, 200000, 900000, 20000, 1000, 0, 50000},
    /* Taps. */
    {0, LETOFF_FINGER_STRUCK, 1000000, 1130000, 500000, 11000, 0, 50000},
    {0, LETOFF_FINGER_STRUCK, 1250000, 1380000, 500000, 11000, 0, 50000},
    {0, LETOFF_FINGER_STRUCK, 1500000, 1630000, 500000, 11000, 0, 50000},
    /* Presses slowly, holds at the bottom for 0.5 s, lifts slowly. */
    {0, LETOFF_FINGER_PRESSED, 1700000, 3100000, 40000, 26660, 0, 150000},
    /* Holds half way for 0.5 s. */
    {0, LETOFF_FINGER_PRESSED, 3300000, 4000000, 60000, 6500, 0, 50000},
    /* Strikes at 0.3, 1.0 and 2.5 m/s; the last one is lifted quickly. */
    {0, LETOFF_FINGER_STRUCK, 4100000, 4380000, 300000, 15160, 0, 50000},
    {0, LETOFF_FINGER_STRUCK, 4500000, 4640000, 1000000, 15160, 0, 50000},
    {0, LETOFF_FINGER_STRUCK, 4750000, 4880000, 2500000, 15160, 0, 15000},
};

static enum script script;
static struct random tremor;
static double tremor_phase;
/* The gesture of `mixed` that plays, counted from the first cycle on; none after power on. */
static uint64_t played = UINT64_MAX;
static struct stroke stroke;
static bool present;

bool finger_begin(const char *name, uint64_t seed)
{
    for (int i = 0; i < SCRIPT_COUNT; i++) {
        if (strcmp(names[i], name) == 0) {
            script = (enum script)i;
            tremor = random_from(seed, 1);
            tremor_phase = random_between(&tremor, 0.0, TURN);
            return true;
        }
    }
    return false;
}

const char *finger_script(void)
{
    return names[script];
}

static bool slow(double t, struct command *command)
{
    double phase = TURN * SLOW_HZ * t;
    command->position = (float)(MIDDLE - SLOW_WAY * cos(phase));
    command->velocity = (float)(SLOW_WAY * TURN * SLOW_HZ * sin(phase));
    return true;
}

static bool hold(double t, struct command *command)
{
    double deep = HOLD_SPEED * (t - HOLD_FROM);
    double end = BOTTOM + HOLD_BEYOND;
    command->position = (float)(deep < end ? deep : end);
    command->velocity = (float)(deep < end ? HOLD_SPEED : 0.0);
    return HOLD_FROM <= t;
}

/* Number of the gesture that plays at `us` into the cycle; -1 if none does. */
static int playing(uint32_t us)
{
    int latest = -1;
    for (int i = 0; i < (int)(sizeof mixed / sizeof *mixed); i++) {
        if (mixed[i].start_us <= us && !gesture_is_over(&mixed[i], us)) {
            latest = i;
        }
    }
    return latest;
}

static bool play(uint64_t us, struct command *command, bool *lands)
{
    uint32_t into_us = (uint32_t)(us % CYCLE_US);
    int number = playing(into_us);
    if (number < 0) {
        return false;
    }
    const struct letoff_finger *gesture = &mixed[number];
    uint64_t all = us / CYCLE_US * (sizeof mixed / sizeof *mixed) + (uint64_t)number;
    if (all != played) {
        played = all;
        stroke_of(&stroke, gesture);
        *lands = true;
    }
    int32_t elapsed_us = (int32_t)(into_us - gesture->start_us);
    int32_t lifting_us = (int32_t)into_us - (int32_t)gesture_lift_off(gesture);
    *command = gesture_command(&stroke, 1e-6f * (float)elapsed_us, 1e-6f * (float)lifting_us);
    return true;
}

static void tremble(struct command *command)
{
    double rate = TURN * TREMOR_HZ;
    tremor_phase += STEP * rate + random_between(&tremor, -WANDER, WANDER);
    command->position += (float)(TREMOR * sin(tremor_phase));
    command->velocity += (float)(TREMOR * rate * cos(tremor_phase));
}

bool finger_command(uint64_t us, struct command *command, bool *lands)
{
    double t = 1e-6 * (double)us;
    bool before = present;
    *lands = false;
    switch (script) {
    case SCRIPT_SLOW:
        present = slow(t, command);
        break;
    case SCRIPT_MIXED:
        present = play(us, command, lands);
        break;
    case SCRIPT_HOLD:
        present = hold(t, command);
        break;
    default:
        present = false;
    }
    if (present) {
        tremble(command);
        *lands = *lands || !before;
    }
    return present;
}
