% EMULATE  The emulator of a diagnosis: of the simulation, or of a change.
%
% CALL: EMULATOR = emulate (PROBLEM, DATA, OPTIONS)
% CALL: EMULATOR = emulate (PROBLEM, DATA, OPTIONS, OLD)
%
%   PROBLEM, DATA, OPTIONS     see fitEmulator
%   OLD                        EMULATOR of other runs
%   EMULATOR                   of fitEmulator, then of emulateChange

function emulator = emulate (problem, data, options, varargin)
  old = cellfun (@emulateChange, varargin, 'UniformOutput', false);
  emulator = emulateChange (fitEmulator (problem, data, options, old{:}), ...
                            problem);
end

%!test
%! % without a reference that of fitEmulator; what another one has learned of
%! % the surrogates is taken on
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! problem = newProblem (given);
%! options = gapOptions (struct ('trend', 'affine'));
%! emulator = emulate (problem, data, options);
%! assert (emulator.coef, fitEmulator (problem, data, options).coef);
%! assert (isempty (emulator.change));
%! again = emulate (problem, data, options, emulator);
%! assert (again.coef, emulator.coef, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
