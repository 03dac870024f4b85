% SAVESURROGATES  Keeps surrogates as text files in a folder.
%
% CALL: NAMES = saveSurrogates (SURROGATES, FOLDER)
%
% SURROGATES  1 x T struct array, see fitSurrogate
% FOLDER      folder that holds them, made where it is missing (text)
% NAMES       1 x T cellstr, KM_fun_<i>: the file <name>.txt holds runs and
%             parameters as text, no program
%
% See also: saveSurrogate, createKrigingModels

function names = saveSurrogates (surrogates, folder)
  [~, ~] = mkdir (folder);
  names = arrayfun (@(t) sprintf ('KM_fun_%d', t), 1:numel (surrogates), ...
                    'UniformOutput', false);
  for t = 1:numel (surrogates)
    saveSurrogate (fullfile (folder, [names{t}, '.txt']), surrogates(t));
  end
end

%!test
%! folder = fullfile (tempname (), 'KrigingFuns');
%! s = fitSurrogate ([0; 0.3; 0.6; 1], [1; 2; 3; 4], [0; 1], struct ());
%! names = saveSurrogates ([s, s], folder);
%! again = loadSurrogate (fullfile (folder, 'KM_fun_2.txt'));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');
%! assert (names, {'KM_fun_1', 'KM_fun_2'});
%! assert (again.z, s.z);
