% WITHORIGIN  What the user knows to have happened, in the effects of a case.
%
% CALL: [CASE, LABEL] = withOrigin (CASE)
%
%   CASE   see newCase, with its candidate effects; of those that make up the cause
%          Input.origin all can have changed, unless loadEffects.m says otherwise
%   LABEL  that cause in words (text); '': Input.origin is not given
%
% Errors: DEcalioc:withOrigin:unknownName
%
% See also: listCauses, changeWords

function [Case, label] = withOrigin (Case)
  origin = givenField (givenField (Case, 'options', struct ()), 'origin', '');
  label = '';
  if isempty (origin)
    return
  end
  causes = listCauses ({fullfile(Case.folder, 'causes'), Case.folder});
  isIt = strcmp ({causes.name}, origin);
  if ~any (isIt)
    error ('DEcalioc:withOrigin:unknownName', ...
           ['withOrigin: Input.origin must be one of %s, got ''%s''. Leave it out ' ...
            'where it is not known what has changed.'], strjoin ({causes.name}, ', '), ...
           origin);
  end
  label = causes(isIt).label;
  members = [causes(isIt).members.effects];
  for k = 1:numel (Case.effects)
    if any (strcmp (Case.effects(k).name, members)) && isempty (Case.effects(k).canChange)
      Case.effects(k).canChange = 'yes';
    end
  end
end

%!test
%! Case.folder = emptyFolder ();
%! Case.effects = resolveEffects ({'shape', 'tilt', struct('name', 'meanSize', ...
%!                                                         'canChange', 'no')});
%! Case.options.origin = '';
%! [same, label] = withOrigin (Case);
%! assert ({isequaln(same, Case), label}, {true, ''});
%! Case.options.origin = 'batch';
%! [Case, label] = withOrigin (Case);
%! assert (label, 'another batch');
%! assert ({Case.effects.canChange}, {'yes', '', 'no'});
%!error id=DEcalioc:withOrigin:unknownName
%! withOrigin (struct ('folder', '', 'effects', [], 'options', struct ('origin', 'rain')))

% SPDX-License-Identifier: GPL-3.0-only
