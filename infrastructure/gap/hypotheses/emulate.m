% EMULATE  The emulator of a diagnosis: of the simulation, or of a change.
%
% CALL: EM = emulate (PROBLEM, DATA, OPTIONS)
% CALL: EM = emulate (PROBLEM, DATA, OPTIONS, OLD)
%
%   PROBLEM, DATA, OPTIONS     see fitEmulator
%   OLD                        EM of other runs
%   EM                         of fitEmulator, then of takeReference

function em = emulate (problem, data, options, varargin)
  old = cellfun (@takeReference, varargin, 'UniformOutput', false);
  em = takeReference (fitEmulator (problem, data, options, old{:}), ...
                      problem);
end

%!test
%! % without a reference that of fitEmulator; what another one has learned of
%! % the surrogates is taken on
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! problem = newProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! em = emulate (problem, data, options);
%! assert (em.coef, fitEmulator (problem, data, options).coef);
%! assert (isempty (em.change));
%! again = emulate (problem, data, options, em);
%! assert (again.coef, em.coef, 1e-9);
