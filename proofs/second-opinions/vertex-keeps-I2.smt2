; Non-loop augmentation maintains I-2
; Says: If U stands for the unexplored edges at G_s, then it does so after e has left it and the
;   other darts of the new vertex have joined it.
; Paper: V, step 2 ('These updates to U maintain I-2')
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   Vertex, Degree  vertices of G; degrees, compared only
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   vertex          the vertex of a dart of G
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   known, explored the same of S: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;                   a name with 0: before the pass, with 1: after it
;   e, entry        the dart explored in this pass; the new dart of S that the robot came in by
;   new, fresh      the darts that the new vertex adds to S; the one that stands for a dart of G
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-sort Vertex 0)
(declare-fun alpha (Dart) Dart)
(declare-fun vertex (Dart) Vertex)
(declare-fun seen0 (Dart) Bool)
(declare-fun walked0 (Dart) Bool)
(declare-fun known0 (MapDart) Bool)
(declare-fun open0 (MapDart) Bool)
(declare-fun phi0 (MapDart) Dart)
(declare-fun name0 (Dart) MapDart)
(declare-fun seen1 (Dart) Bool)
(declare-fun walked1 (Dart) Bool)
(declare-fun known1 (MapDart) Bool)
(declare-fun open1 (MapDart) Bool)
(declare-fun phi1 (MapDart) Dart)
(declare-fun name1 (Dart) MapDart)
(declare-fun new (MapDart) Bool)
(declare-fun fresh (Dart) MapDart)
(declare-const e MapDart)
(declare-const entry MapDart)

; I-1 before, as far as needed: G_s is a subgraph of G
(assert (forall ((d Dart) (c Dart)) (=> (and (seen0 d) (= (vertex c) (vertex d))) (seen0 c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen0 d) (walked0 (alpha d))))))
; I-1 before, as far as needed: phi carries the darts of S one to one to those at vertices of G_s
(assert (forall ((x MapDart)) (=> (known0 x) (and (seen0 (phi0 x)) (= (name0 (phi0 x)) x)))))
(assert (forall ((d Dart)) (=> (seen0 d) (and (known0 (name0 d)) (= (phi0 (name0 d)) d)))))
; I-2 before: phi carries U one to one to the unexplored darts at vertices of G_s
(assert (forall ((x MapDart)) (=> (open0 x) (and (known0 x) (not (walked0 (phi0 x)))))))
(assert (forall ((d Dart)) (=> (and (seen0 d) (not (walked0 d))) (open0 (name0 d)))))
; the pass: e is taken from U, and its other end is at a vertex that is not in G_s
; (all tests failed, see rejected-means-new)
(assert (open0 e))
(assert (not (seen0 (alpha (phi0 e)))))
; that vertex and that edge join G_s
(assert (forall ((d Dart))
  (= (seen1 d) (or (seen0 d) (= (vertex d) (vertex (alpha (phi0 e))))))))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi0 e)) (= d (alpha (phi0 e)))))))
; non-loop augmentation: S gets as many new darts as the new vertex has, numbered clockwise
(assert (forall ((x MapDart))
  (= (new x) (exists ((d Dart)) (and (= (vertex d) (vertex (alpha (phi0 e)))) (= x (fresh d)))))))
(assert (forall ((d Dart)) (=> (= (vertex d) (vertex (alpha (phi0 e)))) (= (phi1 (fresh d)) d))))
(assert (= entry (fresh (alpha (phi0 e)))))
(assert (forall ((x MapDart)) (= (known1 x) (or (known0 x) (new x)))))
(assert (forall ((x MapDart)) (=> (known0 x) (= (phi1 x) (phi0 x)))))
(assert (forall ((d Dart)) (= (name1 d) (ite (seen0 d) (name0 d) (fresh d)))))
; e is removed from U, the other darts of the new vertex are added
(assert (forall ((x MapDart))
  (= (open1 x) (or (and (open0 x) (not (= x e))) (and (new x) (not (= x entry)))))))

; not: I-2 after
(assert (not (and
  (forall ((x MapDart)) (=> (open1 x) (and (known1 x) (not (walked1 (phi1 x))))))
  (forall ((d Dart)) (=> (and (seen1 d) (not (walked1 d))) (open1 (name1 d)))))))
(check-sat)
