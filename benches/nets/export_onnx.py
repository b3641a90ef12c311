"""Writes the four nets of a weights file as one ONNX graph, wired as in src/nets: export_onnx.py WEIGHTS ONNX

Scene [1, 5, 64, 64] in; the maps base, target, action, placement out, each [1, 1, 64, 64] after its sigmoid.
"""

import sys

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper
from safetensors.numpy import load_file

weights, target = sys.argv[1:]
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

graph = helper.make_graph(
    nodes,
    "pathlight",
    [helper.make_tensor_value_info("scene", TensorProto.FLOAT, [1, 5, 64, 64])],
    [helper.make_tensor_value_info(name, TensorProto.FLOAT, [1, 1, 64, 64]) for name in (base, goal, action, placement)],
    [numpy_helper.from_array(tensor, name) for name, tensor in tensors.items()],
)
# A version that every peer can read.
model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
onnx.checker.check_model(model, full_check=True)
onnx.save(model, target)
