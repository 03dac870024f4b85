% EMULATE  The emulator of a diagnosis: of the simulation, or of a change.
%
% CALL: EM = emulate (GAPPROBLEM, DATA, OPTIONS)
% CALL: EM = emulate (GAPPROBLEM, DATA, OPTIONS, OLD)
%
%   GAPPROBLEM, DATA, OPTIONS  see fitEmulator
%   OLD                        EM of other runs
%   EM                         of fitEmulator, then of takeReference

function em = emulate (gapProblem, data, options, varargin)
  old = cellfun (@takeReference, varargin, 'UniformOutput', false);
  em = takeReference (fitEmulator (gapProblem, data, options, old{:}), ...
                      gapProblem);
end

%!test
%! % without a reference that of fitEmulator; what another one has learned of
%! % the surrogates is taken on
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! gapProblem = newProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! em = emulate (gapProblem, data, options);
%! assert (em.coef, fitEmulator (gapProblem, data, options).coef);
%! assert (isempty (em.change));
%! again = emulate (gapProblem, data, options, em);
%! assert (again.coef, em.coef, 1e-9);
