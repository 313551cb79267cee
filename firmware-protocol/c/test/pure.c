/* The parts of the firmware that touch no hardware, held to simple cases on the PC. */
#include "../firmware/arm.h"
#include "../firmware/board.h"
#include "../firmware/forces.h"
#include "../firmware/log.h"
#include "../firmware/plant.h"

#include <stdio.h>
#include <stdlib.h>

static int failures;

#define CHECK(holds)                                                     \
    do {                                                                 \
        if (!(holds)) {                                                  \
            fprintf(stderr, "%s:%d: %s\n", __func__, __LINE__, #holds); \
            failures++;                                                  \
        }                                                                \
    } while (false)

static bool near(float a, float b, float tolerance)
{
    return a - b <= tolerance && b - a <= tolerance;
}

/* The nonce of a board that is disarmed. */
static uint32_t disarmed(struct arm *arm, uint32_t now_us)
{
    uint32_t nonce = 0;
    CHECK(arm_disarm(arm, now_us, &nonce) == LETOFF_STATUS_DONE);
    return nonce;
}

/* A board that was armed for 20 ms; they count from its first forces on. */
static struct arm armed(uint8_t packing)
{
    struct arm arm;
    arm_begin(&arm, 7);
    struct letoff_arm asked = {disarmed(&arm, 0), packing, 20};
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_DONE);
    return arm;
}

static void a_nonce_serves_once(void)
{
    struct arm arm;
    arm_begin(&arm, 7);
    struct letoff_arm asked = {0, LETOFF_FORCES_FORCE16, 20};
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_STATE);
    CHECK(arm.reason == LETOFF_SAFE_NEVER_ARMED && arm_is_safe(&arm));
    asked.nonce = disarmed(&arm, 0);
    asked.nonce ^= 1u;
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_NONCE);
    asked.nonce ^= 1u;
    asked.valid_ms = 101;
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_BAD_VALUE);
    asked.valid_ms = 5;
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_DONE);
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_STATE);
    uint32_t newer = disarmed(&arm, 0);
    CHECK(newer != asked.nonce);
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_NONCE);
    asked.nonce = newer;
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_DONE);
    CHECK(arm.armings == 2 && !arm_is_safe(&arm));
}

static void before_the_first_forces_there_are_none_and_nothing_expires(void)
{
    struct arm arm = armed(LETOFF_FORCES_FORCE16);
    for (uint32_t now_us = 0; now_us < 1000000u; now_us += 1000u) {
        CHECK(arm_share(&arm, now_us) == 0 && !arm_check(&arm, now_us));
    }
    arm_feed(&arm, 1020000u);
    CHECK(arm_share(&arm, 1020000u) == ARM_FULL && arm_check(&arm, 1020001u));
    /* Nor does anything fade that never was. */
    arm = armed(LETOFF_FORCES_FORCE16);
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 5);
    CHECK(arm_share(&arm, 5) == 0);
}

static void forces_expire_fade_and_stay_away(void)
{
    /* Just before the clock wraps. */
    uint32_t start = UINT32_MAX - 25000u;
    struct arm arm = armed(LETOFF_FORCES_FORCE16);
    arm_feed(&arm, start + 20000u);
    CHECK(arm_share(&arm, start + 20000u) == ARM_FULL && !arm_check(&arm, start + 20000u));
    /* The same whether somebody has checked or not. */
    CHECK(arm_share(&arm, start + 25000u) == 500);
    CHECK(arm_check(&arm, start + 25000u) && !arm_check(&arm, start + 25000u));
    CHECK(arm.mode == ARM_SAFE && arm.reason == LETOFF_SAFE_SILENCE && arm_is_safe(&arm));
    CHECK(arm_share(&arm, start + 25000u) == 500);
    CHECK(arm_share(&arm, start + 30000u) == 0);
    arm_feed(&arm, start + 90000u);
    CHECK(arm_share(&arm, start + 31000u) == 0 && arm.trips == 1);
    /* Long after, the clock having gone half around: still nothing. */
    arm_check(&arm, start + 40000u);
    CHECK(arm_share(&arm, start + 0x80000000u) == 0);
}

static void a_stop_fades_from_now_and_forgets_the_nonce(void)
{
    struct arm arm = armed(LETOFF_FORCES_FORCE16);
    arm_feed(&arm, 20000);
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 3000);
    CHECK(arm_share(&arm, 3000) == ARM_FULL && arm_share(&arm, 13000) == 0);
    /* Stopped again, the fading does not begin again. */
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 12000);
    CHECK(arm_share(&arm, 13000) == 0);
    arm = armed(LETOFF_FORCES_FORCE16);
    struct letoff_arm asked = {disarmed(&arm, 20000), LETOFF_FORCES_FORCE16, 20};
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 20000);
    CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_STATE);
    /* What had expired before is fading already, whether somebody has checked or not. */
    arm = armed(LETOFF_FORCES_FORCE16);
    arm_feed(&arm, 20000);
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 25000);
    CHECK(arm_share(&arm, 25000) == 500);
}

static void a_stop_or_a_failed_key_takes_the_place_of_any_lesser_reason_and_stays(void)
{
    const uint8_t first[2] = {LETOFF_SAFE_EMERGENCY_STOP, LETOFF_SAFE_KEY_FAULT};
    for (size_t i = 0; i < 8; i++) {
        struct arm arm = armed(LETOFF_FORCES_FORCE16);
        /* Armed, never armed, disarmed, silent. */
        if (i / 2 == 1) {
            arm_begin(&arm, 7);
        } else if (i / 2 == 2) {
            disarmed(&arm, 0);
        } else if (i / 2 == 3) {
            arm_feed(&arm, 20000);
            CHECK(arm_check(&arm, 25000) && arm.reason == LETOFF_SAFE_SILENCE);
        }
        arm_stop(&arm, first[i % 2], 26000);
        CHECK(i / 2 != 3 || arm_share(&arm, 26000) == 400);
        arm_stop(&arm, first[1 - i % 2], 27000);
        arm_stop(&arm, LETOFF_SAFE_SILENCE, 27000);
        uint32_t nonce = 0;
        CHECK(arm_disarm(&arm, 28000, &nonce) == LETOFF_STATUS_WRONG_STATE && nonce == 0);
        struct letoff_arm asked = {arm.nonce, LETOFF_FORCES_FORCE16, 20};
        CHECK(arm_arm(&arm, &asked) == LETOFF_STATUS_WRONG_STATE);
        CHECK(arm.mode == ARM_SAFE && arm.reason == first[i % 2]);
    }
}

static void the_history_knows_its_last_64_by_number_and_time(void)
{
    static struct history history;
    bool unanswered = false;
    for (uint32_t i = 0; i < 300; i++) {
        struct history_entry *entry = history_add(&history, 1000u * i, &unanswered);
        CHECK(unanswered == (64 <= i && (i - 64) % 2 == 0));
        entry->owed = true;
        entry->answered = i % 2 == 1;
    }
    for (uint32_t i = 230; i < 310; i++) {
        bool kept = 300 - LETOFF_HISTORY <= i && i < 300;
        uint16_t stamp = (uint16_t)(1000u * i & 0xFFFFu);
        CHECK((history_find(&history, (uint8_t)i, stamp) != NULL) == kept);
        CHECK(history_find(&history, (uint8_t)i, (uint16_t)(stamp + 1u)) == NULL);
    }
}

static struct letoff_forces frame(uint8_t sequence, uint16_t stamp_us, int16_t force)
{
    struct letoff_forces forces = {
        .header = {0, sequence, stamp_us, false},
        .packing = LETOFF_FORCES_FORCE16_SLOPE,
        .n_keys = 1,
        .forces = {force},
        .stiffness = {letoff_slope_code(-4000)},
        .damping = {letoff_slope_code(2000)},
    };
    return forces;
}

static void only_answers_to_what_was_sent_are_taken(void)
{
    static struct history history;
    struct forces forces = {0};
    struct arm arm = armed(LETOFF_FORCES_FORCE16_SLOPE);
    bool unanswered;
    history_add(&history, 1000, &unanswered);
    history_add(&history, 3000, &unanswered);
    struct letoff_forces first = frame(0, 1000, 100);
    struct letoff_forces second = frame(1, 3000, 200);
    struct letoff_forces none = frame(2, 5000, 300);
    struct letoff_forces wrong = frame(1, 3001, 300);
    CHECK(forces_take(&forces, &arm, &history, &none, 4000) == FORCES_STALE);
    CHECK(forces_take(&forces, &arm, &history, &wrong, 4000) == FORCES_STALE);
    CHECK(!arm.fed);
    CHECK(forces_take(&forces, &arm, &history, &second, 4000) == FORCES_TAKEN);
    CHECK(arm.deadline_us == 23000 && near(forces.keys[0].force, 0.2f, 1e-6f));
    /* Older than what was answered; the same again; and too late. */
    CHECK(forces_take(&forces, &arm, &history, &first, 4000) == FORCES_STALE);
    CHECK(forces_take(&forces, &arm, &history, &second, 5000) == FORCES_TAKEN);
    CHECK(forces_take(&forces, &arm, &history, &second, 23001) == FORCES_STALE);
    CHECK(forces.oldest_us == 2000);
    second.packing = LETOFF_FORCES_FORCE16;
    CHECK(forces_take(&forces, &arm, &history, &second, 5000) == FORCES_REFUSED);
    second.packing = LETOFF_FORCES_FORCE16_SLOPE;
    arm_stop(&arm, LETOFF_SAFE_EMERGENCY_STOP, 5000);
    CHECK(forces_take(&forces, &arm, &history, &second, 5000) == FORCES_REFUSED);
}

static void the_law_goes_on_from_the_samples_that_were_answered(void)
{
    struct history_entry samples = {.board_us = 7000, .counts = {4000}, .velocities = {0.1f}};
    struct letoff_forces forces = frame(0, 0, 500);
    struct law_key key;
    law_set(&key, &forces, &samples, 0);
    /* Exactly F0 where the samples were; K is −960 N/m, the next on the side of zero; B 1.92. */
    CHECK(near(law_force(&key, 7000, 4000, 0.1f, ARM_FULL, 30.0f), 0.5f, 1e-6f));
    CHECK(near(law_force(&key, 7000, 5000, 0.1f, ARM_FULL, 30.0f), 0.5f + 0.96f, 1e-5f));
    CHECK(near(law_force(&key, 7000, 4000, 0.2f, ARM_FULL, 30.0f), 0.5f - 0.192f, 1e-5f));
    CHECK(near(law_force(&key, 7000, 4000, 0.1f, 250, 30.0f), 0.125f, 1e-6f));
    CHECK(law_force(&key, 7000, 900000, 0.0f, ARM_FULL, 30.0f) == 30.0f);
    CHECK(law_force(&key, 7000, -900000, 0.0f, ARM_FULL, 30.0f) == -30.0f);
    CHECK(law_force(&key, 7000, 5000, 0.0f, 0, 30.0f) == 0.0f);
    /* A key that moves on as it did feels the same force, for 2 ms; 0.1 m/s is 100 counts a ms. */
    CHECK(near(law_force(&key, 8000, 4100, 0.1f, ARM_FULL, 30.0f), 0.5f, 1e-5f));
    CHECK(near(law_force(&key, 9000, 4200, 0.1f, ARM_FULL, 30.0f), 0.5f, 1e-5f));
    CHECK(near(law_force(&key, 17000, 4200, 0.1f, ARM_FULL, 30.0f), 0.5f, 1e-5f));
    forces.header.flag = true;
    law_set(&key, &forces, &samples, 0);
    CHECK(law_force(&key, 7000, 5000, 1.0f, ARM_FULL, 30.0f) == 0.0f);
}

static void multicast_forces_need_a_bus_time_and_feed_together(void)
{
    struct arm arm = armed(LETOFF_FORCES_MULTICAST16);
    struct forces forces = {0};
    struct bus_clock bus = {false, 0, 0};
    struct letoff_multicast group = {.group = 0, .stamp_us = 60500, .forces = {0}};
    group.forces[29] = -2000;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 1000) == FORCES_STALE);
    bus.heard = true;
    bus.ahead_us = 60000;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 1000) == FORCES_TAKEN);
    /* Without the other group nothing is fed. */
    CHECK(near(forces.keys[0].force, -2.0f, 1e-6f) && !arm.fed);
    group.group = 1;
    group.stamp_us = 61500;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 2000) == FORCES_TAKEN);
    /* As long as the older of the two: 500 us and the agreed 20 ms. */
    CHECK(arm.deadline_us == 20500);
    group.stamp_us = 61400;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 2000) == FORCES_STALE);
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 0, 11, 2000) == FORCES_STALE);
    group.stamp_us = 61600;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 0, 11, 2000) == FORCES_REFUSED);
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 22000) == FORCES_STALE);
    bus.heard_us = 2000u - 1000001u;
    CHECK(forces_multicast(&forces, &arm, &bus, &group, 29, 2, 2000) == FORCES_STALE);
}

static void a_key_at_rest_stays_and_a_pressed_one_reaches_its_felt(void)
{
    static struct plant_key key;
    CHECK(plant_is_still(&key, 0.0f, 1000000));
    CHECK(!plant_is_still(&key, -1.0f, 1000000));
    for (uint32_t step = 0; step < 5000; step++) {
        plant_step(&key, -2.0f, step * STEP_US);
    }
    CHECK(plant_is_still(&key, -2.0f, 1000000));
    /* 2 N less the return spring's 0.3 N on 60 kN/m; friction may keep 0.12 N of it. */
    CHECK(near((float)plant_counts(&key), 10160.0f + 28.3f, 3.0f));
    for (uint32_t step = 0; step < 5000; step++) {
        plant_step(&key, 0.0f, step * STEP_US);
    }
    /* The return spring brings it up. */
    CHECK(near((float)plant_counts(&key), 0.0f, 3.0f));
}

static void gestures_are_played_by_their_start_and_then_forgotten(void)
{
    static struct plant_key key;
    uint32_t start = UINT32_MAX - 100000u;
    struct letoff_finger late = {0, TOUCH_PRESSED, start + 400000u, start + 600000u, 300000, 15160, 0, 0};
    struct letoff_finger early = {0, TOUCH_STRUCK, start, start + 200000u, 500000, 15160, 0, 0};
    CHECK(gestures_add(&key.gestures, &late) && gestures_add(&key.gestures, &early));
    CHECK(gestures_now(&key.gestures, start - 1u) == NULL);
    CHECK(gestures_now(&key.gestures, start)->touch == TOUCH_STRUCK);
    int32_t deepest[2] = {0, 0};
    for (uint32_t step = 0; step < 9000; step++) {
        int32_t counts = plant_counts(&key);
        size_t half = step < 4000 ? 0 : 1;
        deepest[half] = deepest[half] < counts ? counts : deepest[half];
        /* A weight of half a newton takes the key up again. */
        plant_step(&key, 0.5f, start + step * STEP_US);
        CHECK(counts < 2000 || step < 4000 || 3500 < step);
    }
    CHECK(10160 < deepest[0] && deepest[0] < 10600);
    CHECK(10160 < deepest[1] && deepest[1] < 10600);
    CHECK(key.gestures.n == 0 && plant_counts(&key) < 5);
    CHECK(plant_is_still(&key, 0.5f, start + 900000u));
}

static void a_finger_starts_where_its_key_is_and_lifts_in_its_time(void)
{
    struct letoff_finger gesture = {0, TOUCH_PRESSED, 0, 300000, 500000, 15160, 5000, 200000};
    struct stroke stroke;
    stroke_of(&stroke, &gesture);
    CHECK(near(gesture_command(&stroke, 0.0f, -0.3f).position, 5e-3f, 1e-9f));
    CHECK(!gesture_is_over(&gesture, 499999u) && gesture_is_over(&gesture, 500000u));
    CHECK(near(gesture_command(&stroke, 0.5f, 0.2f).position, -0.01f, 1e-6f));
    /* Half of the way between where it is held and where it is lifted to. */
    CHECK(near(gesture_command(&stroke, 0.4f, 0.1f).position, 0.5f * (15.16e-3f - 0.01f), 1e-6f));
    CHECK(stroke.braced == 0.0f);
    gesture.speed = 4500000;
    stroke_of(&stroke, &gesture);
    CHECK(near(stroke.braced, 0.5f, 1e-6f));
}

static void a_gesture_is_smooth_where_its_parts_meet(void)
{
    for (uint8_t touch = 0; touch < 2; touch++) {
        for (uint32_t speed = 20000; speed < 3000000; speed += 97001) {
            struct letoff_finger gesture = {0, touch, 0, 250000, speed, 15160, 0, 0};
            struct stroke stroke;
            stroke_of(&stroke, &gesture);
            struct command last = gesture_command(&stroke, 0.0f, -0.25f);
            for (int32_t us = 100; us < 300000; us += 100) {
                struct command command = gesture_command(&stroke, 1e-6f * (float)us,
                                                         1e-6f * (float)(us - 250000));
                /* The fastest run-up: 1.5 · 3 m/s in 5 ms; lifting 0.1 m takes 4 m/s. */
                CHECK(near(command.velocity, last.velocity, 0.2f));
                float mean = 0.5f * (command.velocity + last.velocity);
                CHECK(near(command.position - last.position, 1e-4f * mean, 1e-6f));
                last = command;
            }
            CHECK(near(last.position, -0.01f, 1e-6f));
        }
    }
}

static void the_log_keeps_its_last_lines(void)
{
    static struct log log;
    struct letoff_log_line line;
    CHECK(!log_read(&log, 0, &line));
    for (uint32_t i = 0; i < 20; i++) {
        log_write(&log, i, "a line of more than the forty-eight bytes that there are for it");
    }
    CHECK(log_read(&log, 19, &line) && line.board_us == 19 && line.lines == 20);
    CHECK(log_read(&log, 4, &line) && line.board_us == 4);
    CHECK(log_read(&log, 3, &line) && line.board_us == 0 && line.text[0] == '(');
    CHECK(!log_read(&log, 20, &line));
}

int main(void)
{
    a_nonce_serves_once();
    before_the_first_forces_there_are_none_and_nothing_expires();
    forces_expire_fade_and_stay_away();
    a_stop_fades_from_now_and_forgets_the_nonce();
    a_stop_or_a_failed_key_takes_the_place_of_any_lesser_reason_and_stays();
    the_history_knows_its_last_64_by_number_and_time();
    only_answers_to_what_was_sent_are_taken();
    the_law_goes_on_from_the_samples_that_were_answered();
    multicast_forces_need_a_bus_time_and_feed_together();
    a_key_at_rest_stays_and_a_pressed_one_reaches_its_felt();
    gestures_are_played_by_their_start_and_then_forgotten();
    a_finger_starts_where_its_key_is_and_lifts_in_its_time();
    a_gesture_is_smooth_where_its_parts_meet();
    the_log_keeps_its_last_lines();
    printf("%d failures\n", failures);
    return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
