; A model of the hypotheses of loop-keeps-I1.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows the three vertices, a0b0 and a1c0; e = B1 and h = C1 are the ends of b1c1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Vertex 0)) (((v0) (v1) (v2))))
(declare-datatypes ((Degree 0)) (((two))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun vertex ((x Dart)) Vertex
  (ite (= x a0) v0 (ite (= x a1) v0 (ite (= x b0) v1 (ite (= x b1) v1 v2)))))
(define-fun degree ((x Dart)) Degree two)
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun next ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun degree_map ((x MapDart)) Degree two)
(define-fun home ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun walked0 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun explored0 ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x C0)))
(define-fun open0 ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun partner0 ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun walked1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun explored1 ((x MapDart)) Bool
  (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun partner1 ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun e () MapDart B1)
(define-fun h () MapDart C1)

(assert (forall ((d Dart)) (= (alpha (alpha d)) d)))
(assert (forall ((d Dart) (c Dart)) (=> (and (seen d) (= (vertex c) (vertex d))) (seen c))))
(assert (forall ((d Dart)) (=> (walked0 d) (and (seen d) (walked0 (alpha d))))))
(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
(assert (forall ((x MapDart)) (=> (explored0 x) (and (known x) (walked0 (phi x))))))
(assert (forall ((x MapDart)) (=> (and (known x) (walked0 (phi x))) (explored0 x))))
(assert (forall ((x MapDart))
  (=> (explored0 x)
      (and (explored0 (partner0 x)) (= (partner0 (partner0 x)) x)
           (= (phi (partner0 x)) (alpha (phi x)))))))
(assert (forall ((x MapDart))
  (=> (known x)
      (and (= (degree_map x) (degree (phi x))) (= (home x) (marked (phi x)))))))
(assert (forall ((x MapDart)) (=> (open0 x) (known x))))
(assert (open0 e))
(assert (open0 h))
(assert (= (alpha (phi e)) (phi h)))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))
(assert (forall ((x MapDart)) (= (explored1 x) (or (explored0 x) (= x e) (= x h)))))
(assert (forall ((x MapDart)) (= (partner1 x) (ite (= x e) h (ite (= x h) e (partner0 x))))))
(check-sat)
