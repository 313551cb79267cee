#include "lever.h"

#include "board.h"

/* The motor: largest force [N], and 1 − exp(−2π · 1 kHz · STEP_US). */
#define MOTOR_LIMIT 30.0f
#define MOTOR_SHARE 0.466512f
#define MOTOR_SETTLED 1e-5f
#define COUNTS_PER_METRE (1e9f / QUANTUM_NM)

#if STEP_US != 100
#error "MOTOR_SHARE is for steps of 100 us"
#endif

int32_t plant_counts(const struct plant_key *key)
{
    float counts = COUNTS_PER_METRE * key->position;
    return (int32_t)(counts < 0.0f ? counts - 0.5f : counts + 0.5f);
}

float plant_velocity(const struct plant_key *key)
{
    return key->velocity;
}

static float limited(float command)
{
    if (command < -MOTOR_LIMIT) {
        return -MOTOR_LIMIT;
    }
    return MOTOR_LIMIT < command ? MOTOR_LIMIT : command;
}

static void step_motor(struct plant_key *key, float command)
{
    float target = limited(command);
    float gap = target - key->motor;
    key->motor = -MOTOR_SETTLED < gap && gap < MOTOR_SETTLED ? target : key->motor + MOTOR_SHARE * gap;
}

bool plant_is_still(const struct plant_key *key, float command, uint32_t until_us)
{
    return !key->playing && key->velocity == 0.0f && key->motor == limited(command) &&
           !gestures_any_by(&key->gestures, until_us) &&
           lever_breakaway(key->position, key->motor) == 0.0f;
}

void plant_step(struct plant_key *key, float command, uint32_t now_us)
{
    float push = lever_play(key, now_us);
    step_motor(key, command);
    lever_step(key, key->motor - push);
}
