"""Plays two tasks with the model, over JSON lines. Needs `pathlight` on the PATH, and Pathlight's folder.

To measure the agent in another simulator, replace the second process: it receives a ball and replies with the outcome.
"""

import json, subprocess

def start(*args):
    return subprocess.Popen(["pathlight", *args], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

def ask(process, line):
    print(json.dumps(line), file=process.stdin, flush=True)
    answer = json.loads(process.stdout.readline())
    if "error" in answer:
        raise ValueError(answer["error"])
    return answer

agent = start("agent", "--setup", "within", "--fold", "0")
simulator = start("simulate", "--batch", "-", "--paths")
for task in ["00007:008", "00002:007"]:
    asked, attempts, outcome = ask(agent, {"task": task}), 0, {}
    while asked["ball"]:
        outcome, attempts = ask(simulator, {"task": task, "ball": asked["ball"]}), attempts + 1
        asked = ask(agent, outcome)
    print(task, outcome["status"], "after", attempts, "attempts")
