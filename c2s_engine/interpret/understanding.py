"""All stages up to the scene, in their order."""

from c2s_engine.interpret.reading import amounts, dates, division, letters, scan, streets, syntax
from c2s_engine.interpret.roles.casting import actors
from c2s_engine.interpret.roles.protagonist import choose_ego
from c2s_engine.interpret.scene import Scene
from c2s_engine.interpret.speed.speeds import speeds
from c2s_engine.interpret.surroundings import environment, place
from c2s_engine.interpret.surroundings.settings import SettingsDetector
from c2s_engine.interpret.what.aftermath import aftermath
from c2s_engine.interpret.what.bearings import against_the_traffic, sides_by_compass
from c2s_engine.interpret.what.claims import claimed
from c2s_engine.interpret.what.clauses import Clauses
from c2s_engine.interpret.what.fill_omissions import fill_omissions
from c2s_engine.interpret.what.foot_crossings import on_foot
from c2s_engine.interpret.what.implicit_roles import implicit_roles, reassign_unnoticed_collisions
from c2s_engine.interpret.what.indicated import indicated
from c2s_engine.interpret.what.onwards import same_side
from c2s_engine.interpret.what.passing import came_up_behind
from c2s_engine.interpret.what.passives import unnamed_doers
from c2s_engine.interpret.what.run_ends import run_ends
from c2s_engine.interpret.what.sense import resolve_across_clauses
from c2s_engine.interpret.what.stated_limits import stated_limits
from c2s_engine.interpret.where.edge_cyclists import place_edge_cyclists
from c2s_engine.interpret.where.relations import Places
from c2s_engine.interpret.where.struck import came_out_into, merged_into
from c2s_engine.interpret.who.mentions import Cast


def understand(text: str) -> Scene:
    """All stages up to the scene."""
    plain = scan.normalised(text)
    sentences = division.sentences(text)
    quantities = amounts.quantities(plain)
    names = streets.without_streets(scan.names(plain, letters.cased(text, plain)))
    numbered = scan.of_fleets(plain, names)
    quantities += [
        b
        for b in amounts.bare_speeds(plain)
        if not any(q.start < b.end and b.start < q.end for q in (*quantities, *numbered))
    ]
    quantities.sort(key=lambda s: s.start)
    taken = [(q.start, q.end) for q in quantities]
    names = [n for n in names if not any(s < n.end and n.start < e for s, e in taken)]
    spans = sorted(names + quantities, key=lambda s: s.start)
    sentences = division.shorthand(plain, sentences, names)
    road = place.read(plain, sentences, quantities)
    words = syntax.parse(text, plain, sentences, dates.besides(plain, spans))
    cast = Cast(words)
    clauses = Clauses(words, cast)
    reassign_unnoticed_collisions(cast, clauses)
    endings = run_ends(plain, sentences, clauses)
    unnamed_doers(cast, clauses)
    merged_into(clauses)
    came_out_into(clauses)
    came_up_behind(clauses)
    choose_ego(cast, clauses)
    implicit_roles(cast, clauses)
    claimed(cast, clauses)
    aftermath(cast, clauses)
    against_the_traffic(clauses)
    sides_by_compass(clauses)
    indicated(cast, clauses)
    same_side(clauses)
    places = Places(cast, clauses)
    place_edge_cyclists(clauses, places.of, road)
    on_foot(plain, road, clauses)
    resolve_across_clauses(cast, clauses, road)
    fill_omissions(cast, clauses)
    limits = stated_limits(plain, sentences, quantities, cast, clauses)
    settings = SettingsDetector().detect(plain, sentences)
    light = environment.light(plain, sentences)
    scene = Scene(text, plain, sentences, words, cast, clauses, places, road, settings, light)
    scene.spans, scene.endings, scene.limits = spans, endings, limits
    scene.actors = actors(scene)
    speeds(scene, quantities)
    return scene
