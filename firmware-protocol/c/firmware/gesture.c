#include "gesture.h"

/* Height of a lifted finger [m], and the time that lifting takes: usual, least and most [us]. */
#define LIFT_HEIGHT 10e-3f
#define LIFT_US 50000u
#define LEAST_LIFT_US 10000u
#define MOST_LIFT_US 1000000u
/* Height from which a struck gesture starts [m]. */
#define STRIKE_HEIGHT 20e-3f
/* Parts of the way within which a gesture gains its speed. */
#define PRESSED_RUN_UP 0.5f
#define STRUCK_RUN_UP 0.75f
/* Overshoot of an infinitely fast stroke [m], and the speed of half of it [m/s]. */
#define OVERSHOOT 50e-3f
#define OVERSHOOT_SPEED 0.6f
/* Time at the peak, and from there to the hold depth [s]. */
#define DWELL 20e-3f
#define SETTLE 80e-3f
#define SLOWEST 1e-3f
#define FASTEST 20.0f
#define SHALLOWEST 1e-3f
/* Of the hold depth: deepest start; of the usual run-up: the least. */
#define DEEPEST 0.6f
#define LEAST_RUN_UP 0.1f
/* How much deeper than its key's bottom a finger is held [m]. */
#define PUSH 5e-3f
/* Speeds from which a finger braces itself, and at which it is as stiff as it gets [m/s]. */
#define BRACED_FROM 3.0f
#define BRACED_TO 6.0f

static float clamp(float x, float least, float most)
{
    return x < least ? least : most < x ? most : x;
}

static float cubic(float x)
{
    return x * x * (3.0f - 2.0f * x);
}

static float cubic_integral(float x)
{
    return x * x * x * (1.0f - 0.5f * x);
}

static float quintic(float x)
{
    return x * x * x * (10.0f + x * (6.0f * x - 15.0f));
}

static float quintic_slope(float x)
{
    float hump = x * (1.0f - x);
    return 30.0f * hump * hump;
}

static uint32_t lift_us(const struct letoff_finger *gesture)
{
    uint32_t lift = gesture->lift == 0u ? LIFT_US : gesture->lift;
    return lift < LEAST_LIFT_US ? LEAST_LIFT_US : MOST_LIFT_US < lift ? MOST_LIFT_US : lift;
}

void stroke_of(struct stroke *stroke, const struct letoff_finger *gesture)
{
    float speed = clamp(1e-6f * (float)gesture->speed, SLOWEST, FASTEST);
    float hold = 1e-6f * (float)gesture->hold;
    stroke->hold = hold < SHALLOWEST ? SHALLOWEST : hold;
    stroke->speed = speed;
    stroke->from = clamp(1e-6f * (float)gesture->from, 0.0f, DEEPEST * stroke->hold);
    /* What is left of the way to the key's bottom: the run-up shrinks with its square. */
    float bottom = stroke->hold - PUSH < SHALLOWEST ? SHALLOWEST : stroke->hold - PUSH;
    float part = 1.0f - stroke->from / bottom;
    float way = PRESSED_RUN_UP * stroke->hold * clamp(part * part, LEAST_RUN_UP, 1.0f);
    if (gesture->touch == TOUCH_STRUCK) {
        stroke->from = -STRIKE_HEIGHT;
        way = STRUCK_RUN_UP * STRIKE_HEIGHT;
    }
    stroke->run_up = 2.0f * way / speed;
    stroke->per_run_up = 1.0f / stroke->run_up;
    stroke->overshoot = OVERSHOOT * speed / (speed + OVERSHOOT_SPEED);
    stroke->cruise = (stroke->hold - stroke->from) / speed - 0.5f * stroke->run_up;
    stroke->brake = 2.0f * stroke->overshoot / speed;
    stroke->per_brake = 1.0f / stroke->brake;
    stroke->per_lift = 1e6f / (float)lift_us(gesture);
    stroke->braced = clamp((speed - BRACED_FROM) * (1.0f / (BRACED_TO - BRACED_FROM)), 0.0f, 1.0f);
}

static struct command running_up(const struct stroke *stroke, float x)
{
    struct command command = {
        stroke->from + stroke->speed * stroke->run_up * cubic_integral(x),
        stroke->speed * cubic(x),
    };
    return command;
}

static struct command braking(const struct stroke *stroke, float x)
{
    struct command command = {
        stroke->hold + stroke->speed * stroke->brake * (x - cubic_integral(x)),
        stroke->speed * (1.0f - cubic(x)),
    };
    return command;
}

static struct command settling(const struct stroke *stroke, float elapsed)
{
    float x = clamp(elapsed * (1.0f / SETTLE), 0.0f, 1.0f);
    struct command command = {stroke->hold, 0.0f};
    if (x < 1.0f) {
        command.position += stroke->overshoot * (1.0f - quintic(x));
        command.velocity = -stroke->overshoot * quintic_slope(x) * (1.0f / SETTLE);
    }
    return command;
}

/* The way down, as if it were never released. */
static struct command stroke_command(const struct stroke *stroke, float elapsed)
{
    float cruising = elapsed - stroke->run_up;
    float after = cruising - stroke->cruise;
    if (cruising < 0.0f) {
        return running_up(stroke, clamp(elapsed * stroke->per_run_up, 0.0f, 1.0f));
    }
    if (after < 0.0f) {
        struct command command = {
            stroke->from + stroke->speed * (0.5f * stroke->run_up + cruising),
            stroke->speed,
        };
        return command;
    }
    if (after < stroke->brake) {
        return braking(stroke, clamp(after * stroke->per_brake, 0.0f, 1.0f));
    }
    return settling(stroke, after - stroke->brake - DWELL);
}

struct command gesture_command(const struct stroke *stroke, float elapsed, float lifting)
{
    struct command command = stroke_command(stroke, elapsed);
    if (lifting <= 0.0f) {
        return command;
    }
    float x = clamp(lifting * stroke->per_lift, 0.0f, 1.0f);
    float lifted = quintic(x);
    float rate = quintic_slope(x) * stroke->per_lift;
    float way = -LIFT_HEIGHT - command.position;
    command.position += lifted * way;
    command.velocity = command.velocity * (1.0f - lifted) + rate * way;
    return command;
}

/* ---- Those that wait. ---- */

static int32_t from_to(uint32_t from_us, uint32_t to_us)
{
    return letoff_signed(to_us - from_us, 32);
}

uint32_t gesture_lift_off(const struct letoff_finger *gesture)
{
    bool before = from_to(gesture->start_us, gesture->release_us) < 0;
    return before ? gesture->start_us : gesture->release_us;
}

bool gesture_is_over(const struct letoff_finger *gesture, uint32_t now_us)
{
    return 0 <= from_to(gesture_lift_off(gesture) + lift_us(gesture), now_us);
}

static bool has_started(const struct letoff_finger *gesture, uint32_t now_us)
{
    return 0 <= from_to(gesture->start_us, now_us);
}

bool gestures_add(struct gestures *gestures, const struct letoff_finger *gesture)
{
    if (MOST_GESTURES <= gestures->n) {
        return false;
    }
    size_t at = gestures->n++;
    while (0 < at && from_to(gestures->waiting[at - 1].start_us, gesture->start_us) < 0) {
        gestures->waiting[at] = gestures->waiting[at - 1];
        at--;
    }
    gestures->waiting[at] = *gesture;
    return true;
}

const struct letoff_finger *gestures_now(struct gestures *gestures, uint32_t now_us)
{
    size_t i = 0;
    const struct letoff_finger *latest = NULL;
    while (i < gestures->n && has_started(&gestures->waiting[i], now_us)) {
        if (gesture_is_over(&gestures->waiting[i], now_us)) {
            gestures->n--;
            memmove(&gestures->waiting[i], &gestures->waiting[i + 1],
                    (gestures->n - i) * sizeof gestures->waiting[0]);
        } else {
            latest = &gestures->waiting[i++];
        }
    }
    return latest;
}

bool gestures_any_by(const struct gestures *gestures, uint32_t until_us)
{
    return 0 < gestures->n && has_started(&gestures->waiting[0], until_us);
}
