#include "lever.h"

#include "board.h"

/* One step [s]. */
#define H (1e-6f * STEP_US)
/* The key: mass [kg], damping [N s/m], return spring [N], friction moving and at rest [N]. */
#define MASS 0.040f
#define DAMPING 1.0f
#define RETURN 0.3f
#define COULOMB 0.10f
#define STICTION 0.12f
/* The felts: where the key bottom is [m], stiffness [N/m], damping [N s/m]. */
#define BOTTOM 10.16e-3f
#define FELT_STIFFNESS 60e3f
#define FELT_DAMPING 30.0f
/* The finger: mass, damping, stiffness, and those of its pulp. */
#define TIP_MASS 6e-3f
#define TIP_DAMPING 4.0f
#define TIP_STIFFNESS 400.0f
/* How many times as stiff, and as damped, a braced finger is. */
#define BRACED_STIFFNESS 3.25f
#define BRACED_DAMPING 1.75f
#define PULP_STIFFNESS 4e3f
#define PULP_DAMPING 3.0f
#define AWAY (-20e-3f)

static float magnitude(float x)
{
    return x < 0.0f ? -x : x;
}

/* ---- The felt that is nearer. ---- */

struct resistance {
    /* Direction into the felt, down positive; push at rest, and per velocity at the end. */
    float sign;
    float preload;
    float slope;
};

static struct resistance resistance(float position, float h)
{
    bool up = position < BOTTOM - position;
    struct resistance felt;
    felt.sign = up ? -1.0f : 1.0f;
    /* The return spring leaves the key at 0. */
    float depth = up ? RETURN / FELT_STIFFNESS - position : position - BOTTOM;
    felt.preload = FELT_STIFFNESS * depth;
    felt.slope = FELT_STIFFNESS * h + (0.0f < depth ? FELT_DAMPING : 0.0f);
    return felt;
}

float lever_breakaway(float position, float force)
{
    struct resistance felt = resistance(position, 0.0f);
    float push = 0.0f < felt.preload ? -felt.sign * felt.preload : 0.0f;
    float net = push - force - RETURN;
    if (magnitude(net) <= STICTION) {
        return 0.0f;
    }
    return net < 0.0f ? -1.0f : 1.0f;
}

/* Velocity after a step under `force`, with friction against `direction`. */
static float sliding(const struct plant_key *key, float force, float direction)
{
    struct resistance felt = resistance(key->position, H);
    float inertia = MASS + H * DAMPING;
    float impulse = MASS * key->velocity - H * (force + RETURN + direction * COULOMB);
    float free = impulse * (1.0f / (MASS + H * DAMPING));
    if (felt.preload + felt.slope * felt.sign * free <= 0.0f) {
        return free;
    }
    return (impulse - H * felt.sign * felt.preload) / (inertia + H * felt.slope);
}

void lever_step(struct plant_key *key, float force)
{
    float direction = key->velocity < 0.0f ? -1.0f : 1.0f;
    if (key->velocity == 0.0f) {
        direction = lever_breakaway(key->position, force);
    }
    float velocity = direction == 0.0f ? 0.0f : sliding(key, force, direction);
    /* Friction stops motion, it does not reverse it. */
    key->velocity = 0.0f < velocity * direction ? velocity : 0.0f;
    key->position += H * key->velocity;
}

/* ---- The finger. ---- */

static struct command command_at(const struct plant_key *key, uint32_t now_us)
{
    int32_t elapsed = letoff_signed(now_us - key->gesture.start_us, 32);
    int32_t lifting = letoff_signed(now_us - gesture_lift_off(&key->gesture), 32);
    return gesture_command(&key->stroke, 1e-6f * (float)elapsed, 1e-6f * (float)lifting);
}

/* A gesture with another start is another finger, placed where that gesture has it. */
static void begin(struct plant_key *key, const struct letoff_finger *gesture, uint32_t now_us)
{
    bool other = !key->playing || key->gesture.start_us != gesture->start_us;
    bool changed = other || key->gesture.speed != gesture->speed ||
                   key->gesture.hold != gesture->hold || key->gesture.touch != gesture->touch ||
                   key->gesture.from != gesture->from || key->gesture.lift != gesture->lift;
    key->gesture = *gesture;
    if (changed) {
        stroke_of(&key->stroke, gesture);
    }
    if (other) {
        struct command command = command_at(key, now_us);
        key->playing = true;
        key->tip = command.position;
        key->tip_velocity = command.velocity;
    }
}

/* The force between finger and key [N], never negative. */
static float contact(const struct plant_key *key)
{
    float depth = key->tip - key->position;
    if (depth <= 0.0f) {
        return 0.0f;
    }
    float force = PULP_STIFFNESS * depth + PULP_DAMPING * (key->tip_velocity - key->velocity);
    return force < 0.0f ? 0.0f : force;
}

static void step_finger(struct plant_key *key, struct command command, float push)
{
    float braced = key->stroke.braced;
    float stiffness = TIP_STIFFNESS * (1.0f + braced * (BRACED_STIFFNESS - 1.0f));
    float damping = TIP_DAMPING * (1.0f + braced * (BRACED_DAMPING - 1.0f));
    float muscle = stiffness * (command.position - key->tip) + damping * command.velocity;
    float impulse = TIP_MASS * key->tip_velocity + H * (muscle - push);
    key->tip_velocity = impulse / (TIP_MASS + H * (damping + H * stiffness));
    key->tip += H * key->tip_velocity;
}

float lever_touch(struct plant_key *key, struct command command)
{
    float push = contact(key);
    step_finger(key, command, push);
    return push;
}

void lever_leave(struct plant_key *key)
{
    key->playing = false;
    key->tip = AWAY;
}

float lever_play(struct plant_key *key, uint32_t now_us)
{
    const struct letoff_finger *gesture = gestures_now(&key->gestures, now_us);
    if (gesture == NULL) {
        lever_leave(key);
        return 0.0f;
    }
    begin(key, gesture, now_us);
    return lever_touch(key, command_at(key, now_us + STEP_US));
}
