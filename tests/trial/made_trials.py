#!/usr/bin/env python3
"""made_trials.py CONDITIONS SESSIONS: writes a trials.csv with a known effect to stdout.

The errors are lognormal: people, shapes and trials have their own factors. Each condition has 0.8
times the error of the one before, and each session 0.9 times that of the session before.
"""
import math
import random
import sys

conditions, sessions = int(sys.argv[1]), int(sys.argv[2])
random.seed(3)
print("participant,session,condition,shape,is_practice,valid,reason,err_mean_mm")
for person in range(1, 13):
    skill = random.gauss(0.0, 0.3)
    reactions = [0.0] + [random.gauss(0.0, 0.1) for _ in range(1, conditions)]
    for session, name in enumerate(["train", "retention"][:sessions]):
        for condition in range(conditions):
            for shape, shape_log in (("circle", -0.2), ("null", 0.0), ("wave", 0.2)):
                for _ in range(4):
                    log = (skill + reactions[condition] + shape_log + random.gauss(0.0, 0.25) +
                           condition * math.log(0.8) + session * math.log(0.9))
                    row = f"{person},{name},c{condition},{shape}"
                    print(f"{row},false,true,,{math.exp(log):.6f}")
            print(f"{person},{name},c{condition},wave,true,true,,99")
            print(f"{person},{name},c{condition},wave,false,false,max_lifts,99")
            print(f"{person},{name},c{condition},wave,false,true,,")
