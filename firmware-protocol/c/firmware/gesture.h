/* What the muscle of a simulated finger commands during one stroke, as crates/haptics has it. */
#ifndef GESTURE_H
#define GESTURE_H

#include "../letoff_protocol.h"

/* Gestures of one key that wait. */
#define MOST_GESTURES 32

enum touch { TOUCH_PRESSED = LETOFF_FINGER_PRESSED, TOUCH_STRUCK = LETOFF_FINGER_STRUCK };

/* Where a finger shall be [m] and how fast it shall move [m/s], down positive. */
struct command {
    float position;
    float velocity;
};

/* One way down, and how long each part of it takes [s]; with what divisions can be spared. */
struct stroke {
    float from;
    float hold;
    float overshoot;
    float speed;
    float run_up;
    float per_run_up;
    float cruise;
    float brake;
    float per_brake;
    float per_lift;
    /* How far the finger is braced for forte, 0 to 1. */
    float braced;
};

void stroke_of(struct stroke *stroke, const struct letoff_finger *gesture);

/* The command `elapsed` [s] after the start, and `lifting` [s] after the release. */
struct command gesture_command(const struct stroke *stroke, float elapsed, float lifting);

/* When the finger starts to lift [us]: a release before the start counts as the start. */
uint32_t gesture_lift_off(const struct letoff_finger *gesture);

/* Whether there is a finger at `now_us`, from the start until it is lifted. */
bool gesture_is_over(const struct letoff_finger *gesture, uint32_t now_us);

/* Gestures that wait, by their start; all zeros is its beginning. */
struct gestures {
    struct letoff_finger waiting[MOST_GESTURES];
    uint8_t n;
};

/* Adds one; false if there is no room. */
bool gestures_add(struct gestures *gestures, const struct letoff_finger *gesture);

/* Drops those that are over, and returns the one that started last of those that are not; NULL if
 * none has. */
const struct letoff_finger *gestures_now(struct gestures *gestures, uint32_t now_us);

/* Whether one has started by `until_us`. */
bool gestures_any_by(const struct gestures *gestures, uint32_t until_us);

#endif
