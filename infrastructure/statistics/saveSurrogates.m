% SAVESURROGATES  Keeps the surrogates of a case in its folder KrigingFuns.
%
% CALL: saveSurrogates (SURROGATES, FOLDER)
%
%   SURROGATES  1 x T struct array, see fitSurrogate
%   FOLDER      case folder (text)
%
% One file KM_fun_<i>.txt a target: runs and parameters as text, no program.
%
% See also: saveSurrogate, evaluateKriging

function saveSurrogates (surrogates, folder)
  place = fullfile (folder, 'KrigingFuns');
  [~, ~] = mkdir (place);
  for t = 1:numel (surrogates)
    saveSurrogate (fullfile (place, sprintf ('KM_fun_%d.txt', t)), ...
                   surrogates(t));
  end
end
