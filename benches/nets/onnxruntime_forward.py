"""The nets natively by onnxruntime, one thread: onnxruntime_forward.py ONNX FOLDER, of the inputs"""

import sys

import numpy as np
import onnxruntime
from repeat import repeat

onnx, folder = sys.argv[1:]
options = onnxruntime.SessionOptions()
options.intra_op_num_threads = options.inter_op_num_threads = 1
session = onnxruntime.InferenceSession(onnx, options, providers=["CPUExecutionProvider"])
inputs = {
    image.name: np.fromfile(f"{folder}/{image.name}.f32", np.float32).reshape(1, 5, 64, 64)
    for image in session.get_inputs()
}


def forward():
    return session.run(None, inputs)


repeat(np.concatenate([map.ravel() for map in forward()]), forward)
