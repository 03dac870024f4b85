% EMULATE  The emulator of a diagnosis: of the simulation, or of a change.
%
% CALL: EM = emulate (GAPPROBLEM, DATA, OPTIONS)
% CALL: EM = emulate (GAPPROBLEM, DATA, OPTIONS, OLD)
%
%   GAPPROBLEM, DATA, OPTIONS  see fitEmulator
%   OLD                        EM of other runs
%   EM                         of fitEmulator, then of takeReference

function em = emulate (gapProblem, data, options, varargin)
  old = cellfun (@simulationOf, varargin, 'UniformOutput', false);
  em = takeReference (fitEmulator (gapProblem, data, options, old{:}), ...
                      gapProblem);
end
