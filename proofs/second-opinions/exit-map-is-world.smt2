; Termination and the invariant imply that S is G
; Says: G is connected: a set of darts that contains the start and is closed under sigma and alpha
;   is all of G; here this is said of the set of darts at vertices of G_s. If U is empty, phi is
;   then an isomorphism of S and G: a bijection of all darts that carries sigma, alpha and the
;   start.
; Paper: V, step 4
; Symbols:
;   Dart, MapDart   the darts of the world G; the darts of the map S
;   sigma, next     the next dart clockwise, in G; in S
;   alpha, partner  the other end of the same edge, in G; in S, for explored darts
;   seen, walked    G_s, the explored subgraph: darts at its vertices, darts of its edges
;   known, explored the same of S: darts at its vertices, darts of its edges
;   open            the set U
;   phi, name       the isomorphism from S to G_s, and its inverse
;   start, root     the dart faced at the start, and its dart in S
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-fun sigma (Dart) Dart)
(declare-fun alpha (Dart) Dart)
(declare-fun seen (Dart) Bool)
(declare-fun walked (Dart) Bool)
(declare-fun known (MapDart) Bool)
(declare-fun explored (MapDart) Bool)
(declare-fun open (MapDart) Bool)
(declare-fun phi (MapDart) Dart)
(declare-fun name (Dart) MapDart)
(declare-fun next (MapDart) MapDart)
(declare-fun partner (MapDart) MapDart)
(declare-const start Dart)
(declare-const root MapDart)

; G is connected: induction over the darts, for the set of those seen
(assert (=>
  (and (seen start) (forall ((d Dart)) (=> (seen d) (and (seen (sigma d)) (seen (alpha d))))))
  (forall ((d Dart)) (seen d))))
; I-1: phi carries the darts of S one to one to those at vertices of G_s
(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
; I-1: the edge-index condition
(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
; I-1: the edges of S are the edges of G_s
(assert (forall ((x MapDart)) (=> (explored x) (and (known x) (walked (phi x))))))
(assert (forall ((x MapDart)) (=> (and (known x) (walked (phi x))) (explored x))))
(assert (forall ((x MapDart))
  (=> (explored x)
      (and (explored (partner x)) (= (partner (partner x)) x)
           (= (phi (partner x)) (alpha (phi x)))))))
; I-1: the start is in S
(assert (known root))
(assert (= (phi root) start))
; I-2: each unexplored end at G_s has its entry in U
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
; U is empty
(assert (forall ((x MapDart)) (not (open x))))

; not: phi is an isomorphism of rooted maps
(assert (not (and
  (forall ((x MapDart)) (=> (known x) (= (name (phi x)) x)))
  (forall ((d Dart)) (and (known (name d)) (= (phi (name d)) d)))
  (forall ((x MapDart)) (=> (known x) (= (phi (next x)) (sigma (phi x)))))
  (forall ((x MapDart)) (=> (known x) (and (explored x) (= (phi (partner x)) (alpha (phi x))))))
  (= (name start) root))))
(check-sat)
