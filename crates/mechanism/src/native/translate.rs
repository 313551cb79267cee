use std::collections::{BTreeMap, HashMap};

use crate::expressions::graph::UnaryFunction;
use crate::expressions::tape::{AngleGroup, AngleValues, Argument, Instruction, Tape, TapeSlot};
use cranelift_codegen::ir::{
    Function, InstBuilder as _, MemFlagsData, StackSlotData, StackSlotKind, Value, types::F64,
};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::JITModule;
use cranelift_module::{FuncId, Module as _};

use crate::native::arithmetic;
use crate::native::functions::Callees;

pub(crate) fn translate(
    tape: &Tape,
    module: &mut JITModule,
    callees: &Callees,
    function: &mut Function,
    context: &mut FunctionBuilderContext,
) {
    let mut builder = FunctionBuilder::new(function, context);
    let entry = builder.create_block();
    builder.append_block_params_for_function_params(entry);
    builder.switch_to_block(entry);
    builder.seal_block(entry);
    let pointers = builder.block_params(entry).to_vec();
    let mut translation =
        Translation { tape, module, callees, builder, pointers, values: HashMap::new() };
    translation.instructions();
    translation.outputs();
    translation.builder.ins().return_(&[]);
    let target = translation.module.target_config();
    translation.builder.finalize(target);
}

struct Translation<'a, 'f> {
    tape: &'a Tape,
    module: &'a mut JITModule,
    callees: &'a Callees,
    builder: FunctionBuilder<'f>,
    /// Addresses of constants, state, input, extra, out.
    pointers: Vec<Value>,
    values: HashMap<TapeSlot, Value>,
}

impl Translation<'_, '_> {
    fn instructions(&mut self) {
        let groups: BTreeMap<usize, AngleGroup> = self.tape.angle_groups().into_iter().collect();
        let uses = self.tape.uses();
        for (at, (instruction, uses)) in self.tape.instructions.iter().zip(uses).enumerate() {
            if let Some(group) = groups.get(&at) {
                self.group(group);
            }
            let slot = TapeSlot(u32::try_from(at).unwrap_or(u32::MAX));
            if uses > 0 && !self.values.contains_key(&slot) {
                let value = self.instruction(*instruction);
                self.values.insert(slot, value);
            }
        }
    }

    fn instruction(&mut self, instruction: Instruction) -> Value {
        match instruction {
            Instruction::Number(number) => self.builder.ins().f64const(number),
            Instruction::Argument(argument) => self.argument(argument),
            Instruction::Add(x, y) => {
                let (x, y) = (self.values[&x], self.values[&y]);
                self.builder.ins().fadd(x, y)
            }
            Instruction::Subtract(x, y) => {
                let (x, y) = (self.values[&x], self.values[&y]);
                self.builder.ins().fsub(x, y)
            }
            Instruction::Multiply(x, y) => {
                let (x, y) = (self.values[&x], self.values[&y]);
                self.builder.ins().fmul(x, y)
            }
            Instruction::Divide(x, y) => {
                let (x, y) = (self.values[&x], self.values[&y]);
                self.builder.ins().fdiv(x, y)
            }
            Instruction::Negate(x) => {
                let x = self.values[&x];
                self.builder.ins().fneg(x)
            }
            Instruction::Unary(UnaryFunction::Sin | UnaryFunction::Cos, x) => {
                self.repeated(x, instruction)
            }
            Instruction::Unary(function, x) => {
                let x = self.values[&x];
                match self.callees.unary(function) {
                    Some(callee) => self.call(callee, &[x]),
                    None => arithmetic::unary(&mut self.builder, function, x),
                }
            }
            Instruction::Binary(function, x, y) => {
                let (x, y) = (self.values[&x], self.values[&y]);
                match self.callees.binary(function) {
                    Some(callee) => self.call(callee, &[x, y]),
                    None => arithmetic::binary(&mut self.builder, function, x, y),
                }
            }
            Instruction::Select(condition, positive, other) => {
                let [condition, positive, other] =
                    [condition, positive, other].map(|it| self.values[&it]);
                arithmetic::select(&mut self.builder, condition, positive, other)
            }
        }
    }

    /// Returns a sine or cosine that occurs twice in a tape.
    fn repeated(&mut self, angle: TapeSlot, instruction: Instruction) -> Value {
        let all = (0..).map(TapeSlot).zip(&self.tape.instructions);
        let mut same = all.filter(|(_, it)| **it == instruction);
        match same.find_map(|(slot, _)| self.values.get(&slot)) {
            Some(value) => *value,
            None => self.values[&angle],
        }
    }

    fn argument(&mut self, argument: Argument) -> Value {
        let (list, index) = match argument {
            Argument::Constant(index) => (0, index),
            Argument::State(index) => (1, index),
            Argument::Input(index) => (2, index.into()),
            Argument::Extra(index) => (3, index),
        };
        let flags = MemFlagsData::trusted().with_readonly().with_can_move();
        self.builder.ins().load(F64, flags, self.pointers[list], i32::from(index) * 8)
    }

    fn call(&mut self, callee: FuncId, arguments: &[Value]) -> Value {
        let callee = self.module.declare_func_in_func(callee, self.builder.func);
        let call = self.builder.ins().call(callee, arguments);
        self.builder.inst_results(call)[0]
    }

    fn group(&mut self, group: &AngleGroup) {
        let [one, two] = self.callees.sin_cos;
        match group {
            AngleGroup::One(angle) => {
                let x = self.values[&angle.angle];
                let [sine, cosine] = self.call_writing(one, &[x]);
                self.set(angle, sine, cosine);
            }
            AngleGroup::Two([first, second]) => {
                let angles = [first, second].map(|it| self.values[&it.angle]);
                let [a, b, c, d] = self.call_writing(two, &angles);
                self.set(first, a, c);
                self.set(second, b, d);
            }
        }
    }

    fn call_writing<const N: usize>(&mut self, callee: FuncId, angles: &[Value]) -> [Value; N] {
        let size = u32::try_from(8 * N).unwrap_or(u32::MAX);
        let place = StackSlotData::new(StackSlotKind::ExplicitSlot, size, 3);
        let place = self.builder.create_sized_stack_slot(place);
        let pointer = self.module.target_config().pointer_type();
        let address = self.builder.ins().stack_addr(pointer, place, 0);
        let callee = self.module.declare_func_in_func(callee, self.builder.func);
        let arguments = [angles, &[address]].concat();
        self.builder.ins().call(callee, &arguments);
        core::array::from_fn(|at| {
            let offset = i32::try_from(8 * at).unwrap_or(0);
            self.builder.ins().stack_load(pointer, F64, place, offset)
        })
    }

    fn set(&mut self, angle: &AngleValues, sine: Value, cosine: Value) {
        self.values.extend(angle.sine.map(|slot| (slot, sine)));
        self.values.extend(angle.cosine.map(|slot| (slot, cosine)));
    }

    fn outputs(&mut self) {
        let values: Vec<Value> = self.tape.outputs.iter().map(|slot| self.values[slot]).collect();
        for (at, value) in (0_i32..).zip(values) {
            self.builder.ins().store(MemFlagsData::trusted(), value, self.pointers[4], at * 8);
        }
    }
}
