/* This unit: its identity, its starts, and the condition of its keys.
 *
 * Real hardware answers from its serial number, its flash, its reset register and its sensors.
 */
#ifndef UNIT_H
#define UNIT_H

#include "../letoff_protocol.h"

/* The only reset reason that has a number in the protocol. */
#define RESET_POWER_ON 1u

/* Writes the number that no other board has. */
void unit_uid(uint8_t uid[6]);

/* Starts of the board in its life, this one included. */
uint32_t unit_boots(void);

uint8_t unit_reset_reason(void);

/* Keys whose encoders know their place, slot 0 in bit 0. */
uint16_t unit_homed(void);

/* Keys that have failed, slot 0 in bit 0. */
uint16_t unit_faults(void);

struct letoff_key_health unit_key_health(size_t slot);

#endif
