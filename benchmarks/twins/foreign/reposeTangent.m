% REPOSETANGENT  Tangent of the angle of repose saturates in both frictions.
%
% CALL: R = reposeTangent (SLIDING, ROLLING, LAW)
%
%   SLIDING, ROLLING  n x 1, coefficients of friction
%   LAW   struct of scalars: base (0.3), slide (0.35), soon (0.25: sliding
%         friction at which 1 - 1/e is reached), roll (0.4), turn (0.15)
%   R     n x 1, base + slide (1 - exp (-mu/soon)) + roll tanh (rolling/turn)
%
% Sliding friction counts little once grains roll instead, and rolling friction
% little once they slide: both saturate (Zhou et al. 2002, Wensrich and
% Katterfeld 2012).
%
% See also: drumTangent, foreignLab

function R = reposeTangent (sliding, rolling, law)
  R = law.base - law.slide * expm1 (-sliding / law.soon) + ...
      law.roll * tanh (rolling / law.turn);
end

%!test % from base to base + slide + roll
%! law = struct ('base', 0.3, 'slide', 0.35, 'soon', 0.25, 'roll', 0.4, ...
%!               'turn', 0.15);
%! assert (reposeTangent ([0; 10], [0; 10], law), [0.3; 1.05], 1e-12);
%! assert (all (diff (reposeTangent ((0:0.1:1)', 0.1, law)) > 0));
%! assert (all (diff (reposeTangent (0.4, (0:0.05:0.4)', law)) > 0));
