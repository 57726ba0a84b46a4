/* count.c: a plugin of QEMU's translator that counts executed instructions.
 *
 * Between an execution of the address `begin` and the next one of the address `end` every instruction is counted, the
 * one at `begin` included, and the count is appended as one line to the file `out`. Arguments: begin=ADDRESS,
 * end=ADDRESS, out=FILE. Instructions whose condition is false (in an IT block) count: the core fetches them too.
 *
 * The few declarations of the plugin interface that are needed stand here: distributions ship QEMU without its header.
 * PLUGIN_VERSION is the version of the interface that this QEMU speaks; what is used here is the same in 1 to 4.
 */
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))

struct qemu_plugin_tb;   /* a block of translated instructions */
struct qemu_plugin_insn; /* one of them */
typedef void block_callback(uint64_t id, struct qemu_plugin_tb *block);
typedef void instruction_callback(unsigned int core, void *data);

void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id, block_callback *callback);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *instruction, instruction_callback *callback,
    int registers, void *data);

EXPORT int qemu_plugin_version = PLUGIN_VERSION;
EXPORT int qemu_plugin_install(uint64_t id, const void *about, int argc, char **argv);

static uint64_t begin, end, count;
static int counting;
static FILE *out;

static void on_begin(unsigned int core, void *data)
{
    (void)core, (void)data;
    count = 1;
    counting = 1;
}

static void on_end(unsigned int core, void *data)
{
    (void)core, (void)data;
    if (counting) {
        fprintf(out, "%" PRIu64 "\n", count);
        fflush(out);
    }
    counting = 0;
}

static void on_instruction(unsigned int core, void *data)
{
    (void)core, (void)data;
    ++count;
}

static void on_translation(uint64_t id, struct qemu_plugin_tb *block)
{
    size_t i, n = qemu_plugin_tb_n_insns(block);
    (void)id;
    for (i = 0; i < n; ++i) {
        struct qemu_plugin_insn *instruction = qemu_plugin_tb_get_insn(block, i);
        const uint64_t address = qemu_plugin_insn_vaddr(instruction);
        instruction_callback *callback = address == begin ? on_begin : address == end ? on_end : on_instruction;
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, callback, 0, NULL);
    }
}

int qemu_plugin_install(uint64_t id, const void *about, int argc, char **argv)
{
    int i;
    (void)about;
    for (i = 0; i < argc; ++i) {
        if (!strncmp(argv[i], "begin=", 6)) {
            begin = strtoull(argv[i] + 6, NULL, 0);
        } else if (!strncmp(argv[i], "end=", 4)) {
            end = strtoull(argv[i] + 4, NULL, 0);
        } else if (!strncmp(argv[i], "out=", 4)) {
            out = fopen(argv[i] + 4, "w");
        }
    }
    if (!begin || !end || !out) {
        fprintf(stderr, "count: needs begin=ADDRESS,end=ADDRESS,out=FILE\n");
        return 1;
    }
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
    return 0;
}
