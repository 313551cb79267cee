/* The loop: bytes in, steps, frames out, sleep. */
#include "clock.h"
#include "link.h"
#include "render.h"
#include "uart.h"

/* The longest sleep [us]: well within the steps that are made up for in one go. */
#define LONGEST_SLEEP_US 5000u

static struct state state;
static struct link link_state;

#define RCGC2 (*(volatile uint32_t *)0x400FE108u)
#define GPIOF_LIGHT (*(volatile uint32_t *)0x40025004u)
#define GPIOF_DIR (*(volatile uint32_t *)0x40025400u)
#define GPIOF_DEN (*(volatile uint32_t *)0x4002551Cu)

static void light_begin(void)
{
    RCGC2 |= 1u << 5;
    GPIOF_DIR |= 1u;
    GPIOF_DEN |= 1u;
}

/* Four times a second on and off, as long as somebody looks for this board. */
static void light(uint32_t now_us)
{
    if (state.light && is_due(state.light_us, now_us)) {
        state.light = false;
    }
    GPIOF_LIGHT = state.light ? now_us >> 17 & 1u : 0u;
}

static void receive(uint32_t now_us)
{
    for (int byte = uart_read(); 0 <= byte; byte = uart_read()) {
        link_byte(&link_state, &state, (uint8_t)byte, now_us);
    }
    if (uart_lost() != 0) {
        count(&state.counters.corrupt);
    }
}

/* Sleeps until a byte comes or `us` have passed. */
static void sleep(uint32_t us)
{
    clock_wake_in(us);
    /* With interrupts off neither can come between the question and the sleep, which it ends. */
    __asm volatile("cpsid i" ::: "memory");
    if (!uart_has_byte() && !clock_woke()) {
        __asm volatile("wfi");
    }
    __asm volatile("cpsie i" ::: "memory");
}

int main(void)
{
    clock_begin();
    uart_begin();
    light_begin();
    state_begin(&state, clock_us());
    for (;;) {
        /* Steps first: what has come now applies from now on. */
        render(&state, clock_us());
        uint32_t now_us = clock_us();
        receive(now_us);
        if (arm_check(&state.arm, now_us)) {
            log_write(&state.log, now_us, "forces expired: safe");
        }
        link_samples(&state, now_us);
        link_hello(&state, now_us);
        light(now_us);
        /* Simulated keys need not be stepped while nobody looks: what is due is made up for before
         * the next samples are taken and before the next forces count. */
        sleep(link_idle(&state, now_us, LONGEST_SLEEP_US));
    }
}
