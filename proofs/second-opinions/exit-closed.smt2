; When U is empty, G_s is closed: step along a path from the start
; Says: If U is empty, whoever stands at a vertex of G_s and turns, or crosses an edge, is at a
;   vertex of G_s: no edge has one explored and one unexplored end. (A path from v0 to a vertex
;   outside G_s would contain such an edge.)
; Paper: V, step 4 ('there is an edge on this path with one explored end ...')
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   Vertex, Degree  vertices of G; degrees, compared only
;   sigma, next     the next dart clockwise, in G; in S
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   vertex          the vertex of a dart of G
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;   d               the dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Vertex 0)
(declare-fun sigma (Dart) Dart)
(declare-fun alpha (Dart) Dart)
(declare-fun vertex (Dart) Vertex)
(declare-fun seen (Dart) Bool)
(declare-fun walked (Dart) Bool)
(declare-fun open (MapDart) Bool)
(declare-fun name (Dart) MapDart)
(declare-const d Dart)

; the next dart clockwise is at the same vertex
(assert (forall ((d Dart)) (= (vertex (sigma d)) (vertex d))))
; I-1: G_s is a subgraph of G
(assert (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c))))
(assert (forall ((d Dart)) (=> (walked d) (and (seen d) (walked (alpha d))))))
; I-2: phi carries U one to one to the unexplored darts at vertices of G_s
; (here: each such end has its entry in U)
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
; U is empty
(assert (forall ((x MapDart)) (not (open x))))
; a dart at a vertex of G_s
(assert (seen d))

; not: the next dart and the other end are at vertices of G_s, and the edge is walked
(assert (not (and (seen (sigma d)) (seen (alpha d)) (walked d))))
(check-sat)
