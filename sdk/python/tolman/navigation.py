# SPDX-License-Identifier: BSD-3-Clause
"""What models of spatial cells share: integrated motion, links of views, and when to make experiences and close loops."""
import math

import numpy as np

from tolman.geometry import compose, from_planar, to_planar, wrap_angle
from tolman.parameters import parameter
from tolman.plugins import Cells
from tolman.records import Decision


class Navigator(Cells):
    """A model gives its code of the position: begin(), move(), position(), and recall() of a view."""

    agreement: float = parameter(10, range=(1e-3, 1e6), unit="m", doc="A view nearer than this to the position closes a loop.")
    experience_spacing: float = parameter(5, range=(0, 1e6), unit="m", doc="Distance between experiences.")
    loop_minimum_travel: float = parameter(30, range=(0, 1e9), unit="m", doc="A view must be as old, in m of path.")
    loop_spacing: float = parameter(5, range=(0, 1e9), unit="m", doc="Shortest way between two loops.")

    def begin(self):
        """Sets the code to the origin."""

    def move(self, displacement):
        """Moves the code by metres in the plane: x along the heading at the start, y to its left."""
        raise NotImplementedError

    def position(self):
        """The position by the code, m: an array of x and y."""
        raise NotImplementedError

    def learn(self, template):
        """Links a new view to the present code."""

    def recall(self, template, offset):
        """A view that agrees is seen `offset` metres from where it was learned: corrects the code."""

    def start(self):
        self.heading, self.travel, self.at_loop = 0.0, 0.0, 0.0
        self.experiences, self.here, self.in_here, self.since = 0, -1, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        self.views = {}  # template: x, y, heading, experience, pose in it, travel
        self.state, self.restart, self.clue = "initialising", None, None  # travel at a restart until a place is known again
        self.begin()

    def step(self, motion, place):
        moved = to_planar(motion.T_previous_current)
        displacement = compose((0, 0, self.heading), moved)[:2]
        self.move(np.array(displacement))
        self.heading = (self.heading + moved[2]) % (2 * math.pi)
        self.travel += math.hypot(*displacement)
        self.in_here, self.since = compose(self.in_here, moved), compose(self.since, moved)
        self._restarts(motion.state, moved)
        answer = Decision(template_id=place.template_id)
        view = self.views.get(place.template_id)
        if not (place.recognition == "familiar" and view and self._agrees(view, place, answer)):
            if self.here < 0 or math.hypot(*self.since[:2]) >= self.experience_spacing:
                answer.action, self.here, self.experiences = "create_experience", self.experiences, self.experiences + 1
                self.in_here = self.since = (0.0, 0.0, 0.0)
            answer.relative_yaw = self.in_here[2]
        if place.recognition != "none" and view is None:
            self.views[place.template_id] = (*map(float, self.position()), self.heading, self.here, self.in_here, self.travel)
            self.learn(place.template_id)
        answer.experience, answer.heading = self.here, self.heading
        return answer

    def _restarts(self, state, moved):
        """After a restart of tracking at an unknown pose the code goes on from where it was, until views agree on another place."""
        if state == "initialising" != self.state:
            self.restart, self.clue, self.since = self.travel, None, (math.inf, 0.0, 0.0)
        elif self.clue is not None:
            self.clue = compose(self.clue, moved)
        self.state = state

    def _relocates(self, view, there):
        """Two views from before the restart, one after the other, that agree on one place: the code is set to it."""
        if self.restart is None or view[5] > self.restart:
            return False
        clue, self.clue = self.clue, there
        if clue is None or math.dist(clue[:2], there[:2]) > self.agreement or abs(wrap_angle(clue[2] - there[2])) > 0.5:
            return False
        self.move(np.subtract(there[:2], self.position()))
        self.heading, self.restart, self.at_loop = there[2] % (2 * math.pi), None, -math.inf
        return True

    def _agrees(self, view, place, answer):
        """Closes a loop where the view agrees with the position and the heading."""
        seen = to_planar(place.T_template_current) if place.has_relative_pose else (0.0, 0.0, place.relative_yaw)
        there = compose(view[:3], seen)
        if not self._relocates(view, there) and not self._corrects(view, there, place.template_id):
            return False
        if self.travel - self.at_loop < self.loop_spacing or view[3] == self.here:
            return False
        pose = compose(view[4], seen)
        answer.action, answer.relative_yaw, self.here, self.in_here = "close_loop", pose[2], view[3], pose
        answer.T_experience_current, answer.has_relative_pose = from_planar(*pose), place.has_relative_pose
        if place.has_relative_pose:
            answer.covariance = place.covariance
        self.at_loop = self.travel
        return True

    def _corrects(self, view, there, template):
        """Whether the view agrees with the position and the heading; corrects both by half."""
        off = np.subtract(there[:2], self.position())
        turned = wrap_angle(there[2] - self.heading)
        if self.restart is not None and view[5] <= self.restart:
            return False
        if self.travel - max(view[5], 0) < self.loop_minimum_travel or np.hypot(*off) > self.agreement or abs(turned) > 0.5:
            return False
        self.recall(template, np.subtract(there[:2], view[:2]))
        self.heading = (self.heading + 0.5 * turned) % (2 * math.pi)
        return True
