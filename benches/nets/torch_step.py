"""A training step by PyTorch: torch_step.py WEIGHTS BATCHES THREADS [fused]

The same nets from the same weights on the same batches, one after the other, as in main.rs; `fused` selects PyTorch's fused Adam.
"""

import itertools
import sys

import numpy as np
import torch
from repeat import repeat
from safetensors.torch import load_file
from torch import nn

weights, batches, threads, *fused = sys.argv[1:]
torch.set_num_threads(int(threads))
WIDTHS = [8, 16, 32, 64, 128, 256]


class Hourglass(nn.Module):
    def __init__(self, channels):
        super().__init__()
        outer = [channels, *WIDTHS]
        inner = [1, *WIDTHS]
        # Kernel, stride, padding; the innermost layer has the live taps of a 4 x 4 kernel.
        shape = [(4, 2, 1)] * 5 + [(2, 2, 0)]
        self.down = nn.ModuleList(nn.Conv2d(outer[i], outer[i + 1], *shape[i]) for i in range(6))
        self.up = nn.ModuleList(nn.ConvTranspose2d(inner[i + 1], inner[i], *shape[i]) for i in reversed(range(6)))

    def forward(self, x):
        for layer in [*self.down, *self.up[:-1]]:
            x = torch.relu(layer(x))
        return self.up[-1](x)


class PathNet(nn.Module):
    def __init__(self):
        super().__init__()
        self.base, self.target = Hourglass(5), Hourglass(5)
        self.action, self.placement = Hourglass(7), Hourglass(7)

    def forward(self, scene):
        base, target = self.base(scene), self.target(scene)
        seen = torch.cat([scene, torch.sigmoid(target)], 1)
        action = self.action(torch.cat([seen, torch.sigmoid(base)], 1))
        placement = self.placement(torch.cat([seen, torch.sigmoid(action)], 1))
        return base, target, action, placement


nets = PathNet()
# Only the four nets are trained in this step.
nets.load_state_dict({name: tensor.float() for name, tensor in load_file(weights).items() if not name.startswith("dynamics.")})
adam = torch.optim.Adam(nets.parameters(), lr=3e-3, eps=1e-8, fused=bool(fused))


def parts(batch):
    scene, targets = batch.split([5, 4], 1)
    return scene.contiguous(), [target.contiguous() for target in targets.split(1, 1)]


batches = itertools.cycle(map(parts, torch.from_numpy(np.fromfile(batches, np.float32).reshape(-1, 32, 9, 64, 64))))
cross_entropy = nn.BCEWithLogitsLoss()


def step():
    scene, targets = next(batches)
    adam.zero_grad()
    loss = sum(cross_entropy(logits, target) for logits, target in zip(nets(scene), targets))
    loss.backward()
    adam.step()
    return loss.item()


repeat([step() for _ in range(3)], step)
