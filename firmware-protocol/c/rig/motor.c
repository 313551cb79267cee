#include "motor.h"

#include "../firmware/board.h"
#include "faults.h"

#include <math.h>

#define TURN 6.283185307179586
/* One step [s]. */
#define H (1e-6 * STEP_US)
/* Force per current [N/A], which is also voltage per velocity [V s/m]; resistance [ohm]. */
#define FORCE_CONSTANT 3.0
#define RESISTANCE 1.0
/* Largest current of an amplifier [A], for 30 N, and bandwidth of its loop [Hz]. */
#define MAX_CURRENT 10.0
#define LOOP_HZ 1000.0
/* Voltage without load [V], internal resistance [ohm], and largest current [A] of the supply. */
#define SUPPLY_VOLTAGE 24.0
#define SUPPLY_RESISTANCE 0.05
#define SUPPLY_CURRENT 20.0
/* Room [°C]; heating of a motor [K/W], and its time constant [s]. */
#define ROOM 22.0
#define THERMAL_RESISTANCE 8.0
#define THERMAL_TIME 60.0
/* Way from one tooth to the next [m]. */
#define COGGING_PERIOD 1.2e-3

struct motor {
    double current;
    double temperature;
    double force;
    /* Electrical power that the motor takes [W]; negative while it brakes. */
    double power;
};

static struct motor motors[N_KEYS];

void motors_begin(void)
{
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        motors[slot].temperature = ROOM;
    }
}

static bool has(size_t slot, enum fault fault)
{
    return slot == 0 && fault_is_on(fault);
}

static double clamp(double x, double least, double most)
{
    return x < least ? least : most < x ? most : x;
}

/* Voltage of the supply under the load of all motors. A supply does not take power back, and
 * beyond its largest current it holds that current instead of its voltage. */
static double supply_voltage(void)
{
    double power = 0.0;
    for (size_t slot = 0; slot < N_KEYS; slot++) {
        power += motors[slot].power;
    }
    double current = power <= 0.0 ? 0.0 : power / SUPPLY_VOLTAGE;
    if (SUPPLY_CURRENT < current) {
        return SUPPLY_VOLTAGE * SUPPLY_CURRENT / current - SUPPLY_RESISTANCE * SUPPLY_CURRENT;
    }
    return SUPPLY_VOLTAGE - SUPPLY_RESISTANCE * current;
}

/* Current that the amplifier brings about in the next step. */
static double next_current(size_t slot, double command, double emf)
{
    const struct motor *motor = &motors[slot];
    double voltage = supply_voltage();
    double wanted = clamp(command / FORCE_CONSTANT, -MAX_CURRENT, MAX_CURRENT);
    double target = clamp(wanted, (-voltage - emf) / RESISTANCE, (voltage - emf) / RESISTANCE);
    double hz = has(slot, FAULT_SLOWMOTOR) ? fault_value(FAULT_SLOWMOTOR) : LOOP_HZ;
    return motor->current + (1.0 - exp(-TURN * hz * H)) * (target - motor->current);
}

static double current(size_t slot, double command, double emf, bool powered)
{
    if (has(slot, FAULT_DEADMOTOR)) {
        return 0.0;
    }
    /* A shorted transistor needs no board. */
    if (has(slot, FAULT_STUCK)) {
        return -fault_value(FAULT_STUCK) / FORCE_CONSTANT;
    }
    return powered ? next_current(slot, command, emf) : 0.0;
}

static double force(size_t slot, double position)
{
    double force = FORCE_CONSTANT * motors[slot].current;
    if (has(slot, FAULT_MOTORSIGN)) {
        force = -force;
    }
    if (has(slot, FAULT_WEAK)) {
        force *= fault_value(FAULT_WEAK);
    }
    if (has(slot, FAULT_COGGING)) {
        force += fault_value(FAULT_COGGING) * sin(TURN / COGGING_PERIOD * position);
    }
    return force;
}

double motor_step(size_t slot, double command, double position, double velocity, bool powered)
{
    struct motor *motor = &motors[slot];
    double emf = FORCE_CONSTANT * (has(slot, FAULT_MOTORSIGN) ? velocity : -velocity);
    motor->current = current(slot, command, emf, powered);
    motor->power = motor->current * (RESISTANCE * motor->current + emf);
    double warmth = THERMAL_RESISTANCE * RESISTANCE * motor->current * motor->current;
    motor->temperature += H / THERMAL_TIME * (ROOM + warmth - motor->temperature);
    motor->force = force(slot, position);
    return motor->force;
}

double motor_force(size_t slot)
{
    return motors[slot].force;
}

double motor_current(size_t slot)
{
    return motors[slot].current;
}

double motor_temperature(size_t slot)
{
    return motors[slot].temperature;
}
