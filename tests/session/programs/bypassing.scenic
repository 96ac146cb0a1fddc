"""
TITLE: Bypassing 9
AUTHOR: somebody
DESCRIPTION: Ego overtakes a slow car, then returns to its lane.
SOURCE: a challenge
"""

#################################
# MAP AND MODEL                 #
#################################

param map = localPath('town.xodr')
param carla_map = 'Town05'
model scenic.simulators.carla.model

#################################
# CONSTANTS                     #
#################################

MODEL = 'vehicle.lincoln.mkz_2017'

EGO_SPEED = 10
EGO_BRAKE = 0.8

SLOW_SPEED = 4   # m/s
BYPASS_DIST = 15
INIT_DIST = [20, 25]
TERM_TIME = 8

#################################
# AGENT BEHAVIORS               #
#################################

behavior EgoBehavior():
	try:
		do FollowLaneBehavior(target_speed=EGO_SPEED)
	interrupt when withinDistanceToAnyObjs(self, BYPASS_DIST):
		fasterLaneSec = self.laneSection.fasterLane
		do LaneChangeBehavior(
				laneSectionToSwitch=fasterLaneSec,
				target_speed=EGO_SPEED)

behavior SlowBehavior():
	do FollowLaneBehavior(target_speed=SLOW_SPEED)

#################################
# SPATIAL RELATIONS             #
#################################

initLane = Uniform(*filter(lambda lane:
	all([sec._fasterLane is not None for sec in lane.sections]),
	network.lanes))
egoSpawnPt = new OrientedPoint in initLane.centerline

#################################
# SCENARIO SPECIFICATION        #
#################################

ego = new Car at egoSpawnPt,
	with blueprint MODEL,
	with behavior EgoBehavior()

slow = new Car following roadDirection from egoSpawnPt for Range(*INIT_DIST),
	with blueprint MODEL,
	with behavior SlowBehavior()

require (distance to intersection) > 50
require always (slow.laneSection._fasterLane is not None)
terminate when (distance to egoSpawnPt) > 100
