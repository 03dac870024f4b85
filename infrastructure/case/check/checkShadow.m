% CHECKSHADOW  Checks that no file of a case takes the place of a function.
%
% CALL: P = checkShadow (FOLDER, ROOT)
%
%   FOLDER  case folder (text), where Octave looks for functions first
%   ROOT    folder of the toolbox (text)
%   P       1 x n faults, see checkFault
%
% loadInput, loadEffects and costFunction belong there, and so do own members of
% the families (effect*, execute*, infill*, *Executor). Any other file with the
% name of a function of the toolbox, of Octave or of its packages would be
% called instead, without a word.

function p = checkShadow (folder, root)
  p = checkFault ();
  if strcmp (folder, root) || ~isfolder (folder)
    return
  end
  found = regexp (readdir (folder), '^([A-Za-z]\w*)\.(m|oct|mex)$', ...
                  'tokens', 'once');
  names = cellfun (@(t) t{1}, found(~cellfun (@isempty, found)), ...
                   'UniformOutput', false);
  isMeant = ismember (names, {'loadInput', 'loadEffects', 'costFunction', ...
                              'DEcalioc', 'diagnoseGap'}) | ...
            ~cellfun (@isempty, regexp (names, ['^(effect|execute|infill)|' ...
                                                'Executor$'], 'once'));
  places = placesOf (folder, root);
  for name = names(~isMeant)'
    if exist (name{1}, 'builtin') == 5 || ...
       ~isempty (file_in_path (places, {[name{1}, '.m'], [name{1}, '.oct']}))
      p(end + 1) = checkFault ('shadow', ['The file ', name{1}, ...
                                          '.m of the case folder'], ...
                               ['a name that no function of the toolbox or ' ...
                                'of Octave has'], 'the name of one', ...
                               ['Rename it: it would be called in the place ' ...
                                'of that function.']);
    end
  end
end

% Folders of the path that hold functions of the toolbox, Octave, its packages.
function places = placesOf (folder, root)
  places = strsplit (path (), pathsep ());
  isOurs = strncmp (places, [root, '/infrastructure'], numel (root) + 15) | ...
           ~cellfun (@isempty, strfind (places, '/octave/'));
  isCase = strcmp (places, folder) | ...
           strncmp (places, [folder, '/'], numel (folder) + 1);
  places = strjoin (places(isOurs & ~isCase), pathsep ());
end

%!test
%! folder = emptyFolder ();
%! root = fileparts (fileparts (which ('startToolbox')));
%! for name = {'loadInput.m', 'costFunction.m', 'effectGain.m', ...
%!             'infillAhead.m', 'mineAlone.m', 'sameSet.txt', '2mean.m'}
%!   writeAtomic (fullfile (folder, name{1}), '% x');
%! end
%! assert (isempty (checkShadow (folder, root)));
%! for name = {'sameSet.m', 'strjoin.m', 'numel.m', 'stk_predict.m'}
%!   file = fullfile (folder, name{1});
%!   writeAtomic (file, '% x');
%!   p = checkShadow (folder, root);
%!   assert ({p.id}, {'DEcalioc:checkCase:shadow'});
%!   assert (! isempty (strfind (p.message, name{1})));
%!   unlink (file);
%! end
%!assert (isempty (checkShadow ('/nowhere', '/')))

% SPDX-License-Identifier: GPL-3.0-only
