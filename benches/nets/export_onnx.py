"""Writes the nets of a weights file as ONNX graphs, wired as in src/nets: export_onnx.py WEIGHTS FOUR-NETS ALL-NETS

Scene [1, 5, 64, 64] in; the maps base, target, action, placement out, each [1, 1, 64, 64] after its sigmoid. The second graph
has the logits of the cells too: [1, 8, 64, 64], averaged over the scene and its mirror image.
"""

import sys

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper
from safetensors.numpy import load_file

weights, four_nets, all_nets = sys.argv[1:]
tensors = {name: tensor.astype(np.float32) for name, tensor in load_file(weights).items()}
nodes = []


def add(operator, inputs, output, **attributes):
    nodes.append(helper.make_node(operator, inputs, [output], name=output, **attributes))
    return output


def hourglass(net, x):
    """Adds one net and returns the name of its map; the shape of a layer's weights determines kernel and padding."""
    for half, operator in [("down", "Conv"), ("up", "ConvTranspose")]:
        for layer in range(6):
            name = f"{net}.{half}.{layer}"
            kernel = tensors[f"{name}.weight"].shape[-1]
            padding = {4: 1, 2: 0}[kernel]
            x = add(operator, [x, f"{name}.weight", f"{name}.bias"], name, strides=[2, 2], pads=[padding] * 4,
                    kernel_shape=[kernel, kernel])
            if name != f"{net}.up.5":
                x = add("Relu", [x], f"{name}.relu")
    return add("Sigmoid", [x], net)


base = hourglass("base", "scene")
goal = hourglass("target", "scene")
seen = add("Concat", ["scene", goal], "seen", axis=1)
action = hourglass("action", add("Concat", [seen, base], "seen.base", axis=1))
placement = hourglass("placement", add("Concat", [seen, action], "seen.action", axis=1))



def save(path, outputs):
    """Writes the graph of all nodes so far."""
    used = {name for node in nodes for name in node.input}
    graph = helper.make_graph(
        nodes,
        "pathlight",
        [helper.make_tensor_value_info("scene", TensorProto.FLOAT, [1, 5, 64, 64])],
        [helper.make_tensor_value_info(name, TensorProto.FLOAT, [1, channels, 64, 64]) for name, channels in outputs],
        [numpy_helper.from_array(tensor, name) for name, tensor in tensors.items() if name in used],
    )
    # A version that every peer can read.
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
    onnx.checker.check_model(model, full_check=True)
    onnx.save(model, path)


def mirror(x, output):
    return add("Gather", [x, "columns"], output, axis=3)


maps = [(name, 1) for name in (base, goal, action, placement)]
save(four_nets, maps)

# The logits of the cells: a U-Net whose decoder sees the encoder's output of the same size.
LAYERS = 5
RADII = 8
# The other channels of the last layer are features of balls, which no map shows.
LAST = f"dynamics.up.{LAYERS - 1}"
tensors[f"{LAST}.weight"] = np.ascontiguousarray(tensors[f"{LAST}.weight"][:, :RADII])
tensors[f"{LAST}.bias"] = np.ascontiguousarray(tensors[f"{LAST}.bias"][:RADII])
tensors["columns"] = np.arange(63, -1, -1)
tensors["two"] = np.float32(2)
tensors["halves"] = np.array([1, 1])
x = add("Concat", ["scene", mirror("scene", "mirrored.scene")], "both", axis=0)
skips = []
for half, operator in [("down", "Conv"), ("up", "ConvTranspose")]:
    for layer in range(LAYERS):
        name = f"dynamics.{half}.{layer}"
        x = add(operator, [x, f"{name}.weight", f"{name}.bias"], name, strides=[2, 2], pads=[1] * 4, kernel_shape=[4, 4])
        last = name == LAST
        x = x if last else add("Relu", [x], f"{name}.relu")
        if half == "down":
            skips.append(x)
        elif not last:
            x = add("Concat", [x, skips[LAYERS - 2 - layer]], f"{name}.skip", axis=1)
nodes.append(helper.make_node("Split", [x, "halves"], ["straight", "mirrored"], name="halves.split", axis=0))
total = add("Add", ["straight", mirror("mirrored", "unmirrored")], "sum")
save(all_nets, [*maps, (add("Div", [total, "two"], "success"), RADII)])
